// SPDX-License-Identifier: Apache-2.0
#include "view/slice_widget.h"

#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "model/texts/quantities.h"
#include "model/texts/texts.h"
#include "parts/panel_parts.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>

#include <cmath>

namespace vs::desktop {

namespace {

QString title(render::SliceKind kind) {
    switch (kind) {
    case render::SliceKind::Axial:
        return tr("Axial");
    case render::SliceKind::Coronal:
        return tr("Coronal");
    case render::SliceKind::Sagittal:
        break;
    }
    return tr("Sagittal");
}

// "axialSlider": how scripts find the parts of each.
QByteArray partName(render::SliceKind kind, const char* part) {
    return QByteArray(render::name(kind)) + part;
}

// Wants to be as wide as it ever was, so that the slider beside it keeps still, but gives way: what does not
// fit is left out as a whole, for half a number is another number. Three blanks are between its parts.
class SteadyLabel : public QLabel {
public:
    SteadyLabel() { setProperty("quiet", true); }
    [[nodiscard]] QSize sizeHint() const override {
        widest_ = std::max(widest_, QLabel::sizeHint().width());
        return {widest_, QLabel::sizeHint().height()};
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return {1, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QString shown = text();
        while (!shown.isEmpty() && fontMetrics().horizontalAdvance(shown) > width()) {
            shown.truncate(std::max(0, int(shown.lastIndexOf("   "))));
        }
        QPainter painter(this);
        style()->drawItemText(&painter, rect(), int(alignment()), palette(), isEnabled(), shown,
                              foregroundRole());
    }

private:
    mutable int widest_ = 0;
};

} // namespace

SliceWidget::SliceWidget(StudioController& studio, ToolBox& tools, render::SliceKind kind, QWidget* parent)
    : QWidget(parent), studio_(studio), slices_(studio.slices()), kind_(kind),
      canvas_(named(new SliceCanvas(studio, tools, kind), partName(kind, "Slice").constData(),
                    tr("%1 slice").arg(title(kind)))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeHeader());
    column->addWidget(canvas_, 1);
    connect(canvas_, &SliceCanvas::penMoved, this, &SliceWidget::penMoved);
    connect(canvas_, &SliceCanvas::enlargeRequested, this, &SliceWidget::enlargeRequested);
    connect(&slices_, &SliceController::changed, this, &SliceWidget::refresh);
    refresh();
}

QWidget* SliceWidget::makeHeader() {
    auto* header = new QWidget;
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(6, 1, 4, 1);
    row->setSpacing(6);
    // The colour beside the words: these must be read in either theme.
    auto* name = new QLabel(
        QString("<span style='color: %1'>\u25a0</span> %2").arg(sliceColour(kind_).name(), title(kind_)));
    name->setStyleSheet("font-weight: 600");
    row->addWidget(name);
    slider_ = makeSlider(partName(kind_, "Slider").constData(), tr("%1 slice").arg(title(kind_)), 0, 1, 0);
    slider_->setMinimumWidth(40);
    row->addWidget(slider_, 1);
    place_ = named(new SteadyLabel, partName(kind_, "Place").constData(),
                   tr("Where the %1 slice lies").arg(title(kind_)));
    row->addWidget(place_);
    enlarge_ = makeIconButton("enlarge", partName(kind_, "Enlarge").constData(), tr("Enlarge"),
                              tr("Make this slice large, or all the same size again (double click)"));
    enlarge_->setCheckable(true);
    enlarge_->setIconSize(QSize(15, 15));
    row->addWidget(enlarge_);
    connect(enlarge_, &QToolButton::clicked, this, &SliceWidget::enlargeRequested);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        const auto slice = slices_.geometry(kind_);
        const int index = slice.onwards() > 0 ? value : slice.count() - 1 - value;
        slices_.scroll(kind_, (index - slices_.crosshair()[slice.axis()]) * slice.onwards());
    });
    return header;
}

void SliceWidget::setLarge(bool isLarge) { enlarge_->setChecked(isLarge); }

void SliceWidget::refresh() {
    if (!slices_.hasVolume() || !isVisible()) {
        return;
    }
    const auto slice = slices_.geometry(kind_);
    const int index = slices_.crosshair()[slice.axis()];
    const QSignalBlocker blocked(slider_);
    slider_->setRange(0, slice.count() - 1);
    slider_->setPageStep(std::max(1, slice.count() / 20));
    slider_->setValue(slice.onwards() > 0 ? index : slice.count() - 1 - index);
    // The patient's direction instead of a sign, as for values under the pen.
    const double mm = slice.positionMm(index);
    const auto letters = render::directionLetters(mm < 0 ? -slice.normal() : slice.normal());
    const double stepMm = studio_.host().geometry()->stepMm();
    place_->setText(QString("%1 %2 %3   %4 / %5")
                        .arg(QString::fromStdString(letters), placeText(mm, stepMm), placeUnit(stepMm))
                        .arg(index + 1)
                        .arg(slice.count()));
}

} // namespace vs::desktop

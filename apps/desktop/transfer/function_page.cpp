// SPDX-License-Identifier: Apache-2.0
#include "transfer/function_page.h"

#include "model/studio/studio_controller.h"
#include "parts/colour_button.h"
#include "parts/panel_parts.h"
#include "transfer/function_chart.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

FunctionPage::FunctionPage(StudioController& studio, FunctionEditor& editor, FunctionEditor::Kind kind,
                           FunctionChart* chart, const QString& prefix)
    : studio_(studio), editor_(editor), kind_(kind), chart_(chart), prefix_(prefix) {
    connect(&editor_, &FunctionEditor::changed, this, &FunctionPage::refresh);
    connect(&studio_.host(), &DocumentHost::changed, this, &FunctionPage::refreshHint);
}

QDoubleSpinBox* FunctionPage::makeNumber(const QString& name, const QString& accessibleName) {
    auto* box = makeSpinBox((prefix_ + name).toLatin1().constData(), accessibleName);
    box->setMinimumWidth(60);
    constexpr double kTypable = 1e9;
    box->setRange(-kTypable, kTypable);
    return box;
}

void FunctionPage::setDigits(QDoubleSpinBox* box, const Range& range, bool isWhole) {
    const QSignalBlocker blocker(box);
    const double width = std::max(range.width(), 1e-9);
    box->setDecimals(isWhole ? 0 : std::clamp(int(std::ceil(3 - std::log10(width))), 0, 8));
    box->setSingleStep(isWhole ? 1 : width / 256);
}

void FunctionPage::addLookRow(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    row->setSpacing(3);
    opacity_ = makeNumber("Opacity", tr("Opacity of the chosen part, in percent"));
    opacity_->setRange(0, 100);
    opacity_->setDecimals(1);
    opacity_->setSuffix(tr(" %"));
    opacity_->setFixedWidth(72);
    colour_ = new ColourButton((prefix_ + "Colour").toLatin1().constData(), tr("Colour of the chosen part"));
    const auto button = [&](const char* iconName, const char* name, const QString& text, const QString& tip) {
        auto* made = makeIconButton(iconName, (prefix_ + name).toLatin1().constData(), text, tip);
        made->setIconSize(QSize(18, 18));
        return made;
    };
    auto* add = button("add", "Add", tr("Add"), tr("Add one in the middle; then drag it where it belongs"));
    remove_ =
        button("remove", "Remove", tr("Remove"), tr("Remove the chosen one (Delete, or the right button)"));
    undo_ = button("undo", "Undo", tr("Undo the last change of colours"),
                   tr("Undo the last change of colours (Ctrl+Z on the chart)"));
    row->addWidget(makeQuietLabel(tr("Opacity")));
    row->addWidget(opacity_);
    row->addWidget(colour_);
    row->addStretch(1);
    for (QToolButton* made : {add, remove_, undo_}) {
        row->addWidget(made);
    }
    column->addLayout(row);

    connect(opacity_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
        edit([&](render::TransferFunction& f, std::size_t part) { setOpacity(f, part, percent / 100); });
    });
    connect(chart_, &FunctionChart::colourWanted, colour_, &ColourButton::ask);
    connect(colour_, &ColourButton::asked, &editor_, &FunctionEditor::begin);
    connect(colour_, &ColourButton::tried, this, [this](const QColor& colour) {
        if (const auto part = editor_.chosen(kind_)) {
            const render::Colour taken(colour.red(), colour.green(), colour.blue());
            editor_.change(kind_, [&](render::TransferFunction& f) { setColour(f, *part, taken); });
        }
    });
    connect(colour_, &ColourButton::dropped, this, [this] {
        if (editor_.isEditBegun()) {
            editor_.undo();
        }
    });
    connect(add, &QToolButton::clicked, chart_, &FunctionChart::addPart);
    connect(remove_, &QToolButton::clicked, this, [this] {
        editor_.begin();
        chart_->removeChosen();
    });
    connect(undo_, &QToolButton::clicked, &editor_, &FunctionEditor::undo);
}

void FunctionPage::addHint(QVBoxLayout* column) {
    hint_ = named(makeQuietLabel({}), (prefix_ + "Hint").toLatin1().constData(), tr("Where this is seen"));
    hint_->setWordWrap(true);
    hint_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    column->addWidget(hint_);
    connect(hint_, &QLabel::linkActivated, this, [this](const QString& link) {
        link == "use" ? editor_.use(kind_) : studio_.view().setMode(render::Mode::Volume);
    });
}

void FunctionPage::edit(const std::function<void(render::TransferFunction&, std::size_t)>& change) {
    const auto part = editor_.chosen(kind_);
    if (part) {
        editor_.begin();
        editor_.change(kind_, [&](render::TransferFunction& f) { change(f, *part); });
        refresh(); // what was typed may have been held back
    }
}

void FunctionPage::refresh() {
    if (opacity_ == nullptr) {
        return; // not all built yet
    }
    const auto part = editor_.chosen(kind_);
    for (QWidget* widget : std::initializer_list<QWidget*>{opacity_, colour_, remove_}) {
        widget->setEnabled(part.has_value());
    }
    undo_->setEnabled(editor_.canUndo());
    if (part) {
        const Look look = lookOf(function(), *part);
        const QSignalBlocker blocker(opacity_);
        opacity_->setValue(100 * look.opacity);
        colour_->setColour(screenColour(look.colour));
    }
    refreshNumbers(part);
    refreshHint();
    const std::size_t count =
        kind_ == FunctionEditor::Kind::TwoD ? function().shapes.size() : function().points.size();
    chart_->setProperty(
        "report", chart_->isEmpty()
                      ? tr("no counts")
                      : tr("%1 of %2 chosen").arg(part ? QString::number(*part) : tr("none")).arg(count));
    chart_->setAccessibleDescription(chart_->property("report").toString());
}

void FunctionPage::refreshHint() {
    if (hint_ == nullptr) {
        return;
    }
    QString text;
    if (!editor_.isUsed(kind_)) {
        text = tr("Not in use: edit it, or <a href=\"use\">use it as it is</a>.");
    } else if (studio_.view().shown().mode != render::Mode::Volume) {
        text = tr("Opacities show in <a href=\"volume\">volume mode</a>.");
    }
    hint_->setText(text);
    hint_->setVisible(!text.isEmpty());
}

} // namespace vs::desktop

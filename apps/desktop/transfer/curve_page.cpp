// SPDX-License-Identifier: Apache-2.0
#include "transfer/curve_page.h"

#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"
#include "transfer/curve_view.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include <cmath>

namespace vs::desktop {

CurvePage::CurvePage(StudioController& studio, FunctionEditor& editor, FunctionEditor::Kind kind,
                     const char* name, const QString& prefix)
    : CurvePage(studio, editor, kind, name, prefix, new CurveView(editor, kind)) {}

CurvePage::CurvePage(StudioController& studio, FunctionEditor& editor, FunctionEditor::Kind kind,
                     const char* name, const QString& prefix, CurveView* chart)
    : FunctionPage(studio, editor, kind, chart, prefix), chart_(chart) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    const bool isGradient = kind == FunctionEditor::Kind::Gradient;
    named(chart_, name,
          isGradient ? tr("Opacity and colour over gradient magnitude")
                     : tr("Opacity and colour over intensity"));
    chart_->setToolTip(
        tr("Click: a new point. Drag a point, or a whole hill by its middle. Double click: its "
           "colour. Right button: remove.\nTab: the next point; arrow keys move it; Delete; "
           "Return: its colour; Ctrl+Z. Wheel: closer."));
    column->addWidget(chart_);

    auto* row = new QHBoxLayout;
    row->setSpacing(5);
    value_ = makeNumber("Value", isGradient ? tr("Gradient magnitude of the chosen point")
                                            : tr("Intensity of the chosen point"));
    value_->setMaximumWidth(100);
    unit_ = makeQuietLabel({});
    row->addWidget(makeQuietLabel(isGradient ? tr("Gradient") : tr("Intensity")));
    row->addWidget(value_);
    row->addWidget(unit_);
    row->addStretch(1);
    column->addLayout(row);
    addLookRow(column);
    addHint(column);
    connect(value_, &QDoubleSpinBox::valueChanged, this, &CurvePage::takeTyped);
    refresh();
}

void CurvePage::takeDocument() {
    const auto* document = studio_.host().document();
    const auto& volume = document->volume();
    if (kind_ == FunctionEditor::Kind::Intensity) {
        const bool isWhole = volume.type != volume::ScalarType::Float32;
        chart_->setQuantum(isWhole ? 1 : 0);
        setCounts(document->histogram(), volume.usual, QString::fromStdString(volume.unit));
        setDigits(value_, volume.usual, isWhole);
    } else {
        chart_->setEmptyText(tr("Counting\u2026"));
        chart_->setCounts({});
    }
}

void CurvePage::setCounts(const std::vector<std::uint32_t>& counts, Range range, const QString& unit) {
    chart_->setAxis(range, unit);
    chart_->setCounts(counts);
    setDigits(value_, range, chart_->quantum() > 0);
    unit_->setText(unit);
    layout()->activate(); // its room is there at once, whenever the counts come
    refresh();
}

FunctionPage::Look CurvePage::lookOf(const render::TransferFunction& f, std::size_t part) const {
    const double at = f.points[part].position;
    const auto seen = render::FunctionSampler(f).at(at, at);
    return {f.points[part].opacity, render::colourFromLinear(glm::dvec3(seen))};
}

void CurvePage::setOpacity(render::TransferFunction& f, std::size_t part, double opacity) const {
    render::movePoint(f, part, f.points[part].position, opacity);
}

void CurvePage::setColour(render::TransferFunction& f, std::size_t part, render::Colour colour) const {
    render::paintPoint(f, part, colour);
}

void CurvePage::refreshNumbers(std::optional<std::size_t> part) {
    value_->setEnabled(part.has_value());
    if (part) {
        const QSignalBlocker blocker(value_);
        value_->setValue(function().points[*part].position);
    }
    // The colours of the function, whatever its opacity.
    const auto sampler = std::make_shared<render::FunctionSampler>(function());
    chart_->setColourStrip([sampler](double value) {
        return screenColour(render::colourFromLinear(glm::dvec3(sampler->at(value, value))));
    });
}

void CurvePage::takeTyped(double value) {
    edit([&](render::TransferFunction& f, std::size_t part) {
        render::movePoint(f, part, value, f.points[part].opacity);
        if (const double taken = f.points[part].position; taken != value) {
            studio_.host().say(tr("%1 lies beyond the next point: this one was put to %2")
                                   .arg(value, 0, 'g', 6)
                                   .arg(taken, 0, 'g', 6));
        }
    });
}

} // namespace vs::desktop

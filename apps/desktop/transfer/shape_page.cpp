// SPDX-License-Identifier: Apache-2.0
#include "transfer/shape_page.h"

#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"
#include "transfer/plane_view.h"

#include "render/colours/function_edits.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace vs::desktop {

ShapePage::ShapePage(StudioController& studio, FunctionEditor& editor)
    : ShapePage(studio, editor, new PlaneView(editor)) {}

ShapePage::ShapePage(StudioController& studio, FunctionEditor& editor, PlaneView* chart)
    : FunctionPage(studio, editor, FunctionEditor::Kind::TwoD, chart, "shape"), chart_(chart) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    named(chart_, "plane", tr("Colours over intensity and gradient magnitude"));
    chart_->setToolTip(
        tr("Drag on empty ground: a new shape. Drag a shape, or its corners. Double click: its "
           "colour. Right button: remove; while painting: erase.\nTab: the next shape; arrow "
           "keys move it; Delete; Return: its colour; Ctrl+Z. Wheel: closer."));
    column->addWidget(chart_);
    auto* drawing =
        new ChoiceRow({{"drawBox", tr("Box"), tr("New shapes are boxes")},
                       {"drawTriangle", tr("Triangle"), tr("New shapes stand on a point")},
                       {"drawPaint", tr("Paint"), tr("Paint free-hand; the right button erases")}},
                      0, 3);
    connect(drawing, &ChoiceRow::chosen, this, [this](int choice) {
        drawing_ = choice;
        chart_->setDrawing(PlaneView::Drawing(choice));
        refresh();
    });
    column->addWidget(drawing);
    column->addWidget(brush_ = makeBrush());
    column->addWidget(baseRow_ = makeRange(tr("Intensity"), "Base", baseLo_, baseHi_));
    column->addWidget(topRow_ = makeRange(tr("At its top"), "Top", topLo_, topHi_));
    column->addWidget(gradientRow_ = makeRange(tr("Gradient"), "Gradient", gradientLo_, gradientHi_));
    addLookRow(column);
    addHint(column);
    refresh();
}

QWidget* ShapePage::makeBrush() {
    constexpr int kLeast = 2;
    constexpr int kLargest = 40;
    constexpr int kUsual = 10;
    auto* slider = makeSlider("brushSize", tr("Size of the brush, in pixels"), kLeast, kLargest, kUsual);
    connect(slider, &QSlider::valueChanged, this, [this](int radius) { chart_->setBrush(radius); });
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(makeQuietLabel(tr("Brush")));
    row->addWidget(withValue(slider, [](int radius) { return QString::number(radius); }), 1);
    return holder;
}

QWidget* ShapePage::makeRange(const QString& text, const QString& name, QDoubleSpinBox*& lo,
                              QDoubleSpinBox*& hi) {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(5);
    auto* label = makeQuietLabel(text);
    label->setMinimumWidth(66);
    lo = makeNumber(name + "Lo", tr("%1: lower end").arg(text));
    hi = makeNumber(name + "Hi", tr("%1: upper end").arg(text));
    row->addWidget(label);
    row->addWidget(lo, 1);
    row->addWidget(makeQuietLabel(tr("to")));
    row->addWidget(hi, 1);
    const auto take = [this] {
        edit([this](render::TransferFunction& f, std::size_t part) {
            if (auto* trapezoid = std::get_if<render::Trapezoid>(&f.shapes[part].form)) {
                const bool isBox = trapezoid->base == trapezoid->top;
                trapezoid->base = typed(*baseLo_, *baseHi_, trapezoid->base);
                trapezoid->top = isBox ? trapezoid->base : typed(*topLo_, *topHi_, trapezoid->top);
                trapezoid->gradients = typed(*gradientLo_, *gradientHi_, trapezoid->gradients);
            }
        });
    };
    connect(lo, &QDoubleSpinBox::valueChanged, this, take);
    connect(hi, &QDoubleSpinBox::valueChanged, this, take);
    return holder;
}

Range ShapePage::typed(const QDoubleSpinBox& lo, const QDoubleSpinBox& hi, const Range& before) {
    const Range wanted{numberIn(lo, before.lo), numberIn(hi, before.hi)};
    if (wanted.lo > wanted.hi) {
        studio_.host().say(tr("The ends are exchanged: the lower one comes first."));
        return {wanted.hi, wanted.lo};
    }
    return wanted;
}

void ShapePage::takeDocument() {
    const auto& volume = studio_.host().document()->volume();
    const bool isWhole = volume.type != volume::ScalarType::Float32;
    chart_->setAxis(volume.usual, QString::fromStdString(volume.unit));
    chart_->setQuantum(isWhole ? 1 : 0);
    chart_->setEmptyText(tr("Counting\u2026"));
    chart_->forgetJoint();
    for (QDoubleSpinBox* box : {baseLo_, baseHi_, topLo_, topHi_}) {
        setDigits(box, volume.usual, isWhole);
    }
}

void ShapePage::setJoint(const field::JointHistogram& joint) {
    chart_->setJoint(joint);
    for (QDoubleSpinBox* box : {gradientLo_, gradientHi_}) {
        setDigits(box, joint.gradients, false);
    }
    refresh();
}

FunctionPage::Look ShapePage::lookOf(const render::TransferFunction& f, std::size_t part) const {
    return {f.shapes[part].opacity, f.shapes[part].colour};
}

void ShapePage::setOpacity(render::TransferFunction& f, std::size_t part, double opacity) const {
    f.shapes[part].opacity = std::clamp(opacity, 0.0, 1.0);
}

void ShapePage::setColour(render::TransferFunction& f, std::size_t part, render::Colour colour) const {
    f.shapes[part].colour = colour;
}

void ShapePage::refreshNumbers(std::optional<std::size_t> part) {
    const auto* trapezoid = part ? std::get_if<render::Trapezoid>(&function().shapes[*part].form) : nullptr;
    const bool isPaint = drawing_ == int(PlaneView::Drawing::Paint);
    brush_->setVisible(isPaint);
    baseRow_->setVisible(!isPaint);
    gradientRow_->setVisible(!isPaint);
    baseRow_->setEnabled(trapezoid != nullptr);
    gradientRow_->setEnabled(trapezoid != nullptr);
    topRow_->setVisible(!isPaint && trapezoid != nullptr && !(trapezoid->base == trapezoid->top));
    if (trapezoid == nullptr) {
        return;
    }
    const auto show = [](QDoubleSpinBox* box, double value) {
        const QSignalBlocker blocker(box);
        box->setValue(value);
    };
    show(baseLo_, trapezoid->base.lo);
    show(baseHi_, trapezoid->base.hi);
    show(topLo_, trapezoid->top.lo);
    show(topHi_, trapezoid->top.hi);
    show(gradientLo_, trapezoid->gradients.lo);
    show(gradientHi_, trapezoid->gradients.hi);
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "transfer/function_page.h"

#include "field/gradient.h"

namespace vs::desktop {

class ChoiceRow;
class PlaneView;

// The editor over intensity and gradient magnitude.
class ShapePage : public FunctionPage {
    Q_OBJECT

public:
    ShapePage(StudioController& studio, FunctionEditor& editor);

    void takeDocument() override;
    void setJoint(const field::JointHistogram& joint);

protected:
    [[nodiscard]] Look lookOf(const render::TransferFunction& f, std::size_t part) const override;
    void setOpacity(render::TransferFunction& f, std::size_t part, double opacity) const override;
    void setColour(render::TransferFunction& f, std::size_t part, render::Colour colour) const override;
    void refreshNumbers(std::optional<std::size_t> part) override;

private:
    ShapePage(StudioController& studio, FunctionEditor& editor, PlaneView* chart);
    QWidget* makeRange(const QString& text, const QString& name, QDoubleSpinBox*& lo, QDoubleSpinBox*& hi);
    QWidget* makeBrush();
    // A range that was typed over another one; says a word if its ends were exchanged.
    Range typed(const QDoubleSpinBox& lo, const QDoubleSpinBox& hi, const Range& before);

    PlaneView* chart_;
    QWidget* brush_ = nullptr;
    QWidget* topRow_ = nullptr;
    QWidget* baseRow_ = nullptr;
    QWidget* gradientRow_ = nullptr;
    QDoubleSpinBox* baseLo_ = nullptr;
    QDoubleSpinBox* baseHi_ = nullptr;
    QDoubleSpinBox* topLo_ = nullptr;
    QDoubleSpinBox* topHi_ = nullptr;
    QDoubleSpinBox* gradientLo_ = nullptr;
    QDoubleSpinBox* gradientHi_ = nullptr;
    int drawing_ = 0;
};

} // namespace vs::desktop

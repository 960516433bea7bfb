// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "transfer/function_page.h"

namespace vs::desktop {

class CurveView;

// The editor over intensity, or over gradient magnitude.
class CurvePage : public FunctionPage {
    Q_OBJECT

public:
    CurvePage(StudioController& studio, FunctionEditor& editor, FunctionEditor::Kind kind, const char* name,
              const QString& prefix);

    void takeDocument() override;
    // Shows the histogram of gradients, which is counted when it is first wanted.
    void setCounts(const std::vector<std::uint32_t>& counts, Range range, const QString& unit);
    [[nodiscard]] CurveView& chart() { return *chart_; }

protected:
    [[nodiscard]] Look lookOf(const render::TransferFunction& f, std::size_t part) const override;
    void setOpacity(render::TransferFunction& f, std::size_t part, double opacity) const override;
    void setColour(render::TransferFunction& f, std::size_t part, render::Colour colour) const override;
    void refreshNumbers(std::optional<std::size_t> part) override;

private:
    CurvePage(StudioController& studio, FunctionEditor& editor, FunctionEditor::Kind kind, const char* name,
              const QString& prefix, CurveView* chart);
    void takeTyped(double value);

    CurveView* chart_;
    QDoubleSpinBox* value_ = nullptr;
    QLabel* unit_ = nullptr;
};

} // namespace vs::desktop

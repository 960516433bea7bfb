// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/sketch_tool.h"

#include <optional>

namespace vs::desktop {

// A closed stroke cuts along the view through everything inside it, or outside it, as soon as the pen is
// lifted.
class ScissorsTool : public SketchTool<CutTool> {
    Q_OBJECT

public:
    explicit ScissorsTool(StudioController& studio) : SketchTool(studio) {}

    [[nodiscard]] QString name() const override { return "scissors"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool canActOnSegment() const override { return true; }
    [[nodiscard]] bool canActOnMaterial() const override { return true; }
    void press(const Pen& pen) override;
    [[nodiscard]] Overlays overlays() const override;

    [[nodiscard]] bool cutsOutside() const { return cutsOutside_; }
    void setCutsOutside(bool outside);
    // How deep below the surface is cut, in steps; nothing: through everything.
    [[nodiscard]] std::optional<double> depth() const { return depth_; }
    void setDepth(std::optional<double> steps);

protected:
    void takeSketch() override;
    [[nodiscard]] bool saysWhatItFills() const override { return false; }

private:
    [[nodiscard]] QString doing() const; // the hint, without what it works on

    bool cutsOutside_ = false;
    std::optional<double> depth_;
};

} // namespace vs::desktop

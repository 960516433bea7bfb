// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/sketch_pad.h"
#include "tools/cut_tool.h"

#include <optional>

namespace vs::desktop {

// A closed stroke cuts along the view through everything inside it, or outside it, as soon as the pen is
// lifted.
class ScissorsTool : public CutTool {
    Q_OBJECT

public:
    explicit ScissorsTool(StudioController& studio) : CutTool(studio) {}

    [[nodiscard]] QString name() const override { return "scissors"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool canActOnSegment() const override { return true; }
    [[nodiscard]] Overlays overlays() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override { move(pen); } // between a polyline's corners
    bool accept() override;                            // a polyline ends
    void clear() override;
    void viewResized() override { clear(); }
    [[nodiscard]] bool isBusy() const override { return isSketching_; }
    [[nodiscard]] bool isSketching() const override { return isSketching_; }

    [[nodiscard]] bool cutsOutside() const { return cutsOutside_; }
    void setCutsOutside(bool outside);
    // How deep below the surface is cut, in steps; nothing: through everything.
    [[nodiscard]] std::optional<double> depth() const { return depth_; }
    void setDepth(std::optional<double> steps);

private:
    [[nodiscard]] QString doing() const; // the hint, without what it works on
    void cutSketch();
    bool cutsOutside_ = false;
    std::optional<double> depth_;
    SketchPad pad_;
    bool isSketching_ = false;
};

} // namespace vs::desktop

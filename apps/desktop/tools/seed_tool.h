// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/sketch_tool.h"

namespace vs::desktop {

// Strokes on the visible surface become seeds as soon as the pen is lifted; with auto start on they begin to
// grow. With the sign reversed they take the segment away from there outward.
class SeedTool : public SketchTool<StudioTool> {
    Q_OBJECT

public:
    explicit SeedTool(StudioController& studio) : SketchTool(studio, SketchPad::Needs::Line) {}

    [[nodiscard]] QString name() const override { return "seed"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    void taken() override;
    void putDown() override;

    // The sign reversed: strokes absorb the segment at work from where they are drawn.
    [[nodiscard]] bool hasSign() const override { return true; }
    [[nodiscard]] bool isReversed() const override { return isReversed_; }
    void setReversed(bool reversed) override;

    // The width of strokes that are lines, in logical pixels.
    [[nodiscard]] double width() const { return width_; }
    void setWidth(double pixels) { width_ = pixels; }

protected:
    void takeSketch() override;

private:
    [[nodiscard]] QString doing() const; // the hint of a segment that can be worked on

    bool isReversed_ = false;
    double width_ = 5;
};

} // namespace vs::desktop

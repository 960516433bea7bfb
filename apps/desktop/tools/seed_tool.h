// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/sketch_pad.h"
#include "model/hand/tool.h"

namespace vs::desktop {

class StudioController;

// Strokes on the visible surface become seeds as soon as the pen is lifted; with auto start on they begin to
// grow. With the sign reversed they take the segment away from there outward.
class SeedTool : public Tool {
    Q_OBJECT

public:
    explicit SeedTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "seed"; }
    [[nodiscard]] QString hint() const override;
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

    // The sign reversed: strokes absorb the segment at work from where they are drawn.
    [[nodiscard]] bool hasSign() const override { return true; }
    [[nodiscard]] bool isReversed() const override { return isReversed_; }
    void setReversed(bool reversed) override;

    // The width of strokes that are lines, in logical pixels.
    [[nodiscard]] double width() const { return width_; }
    void setWidth(double pixels) { width_ = pixels; }

private:
    [[nodiscard]] QString doing() const; // the hint of a segment that can be worked on
    void takeStroke();

    StudioController& studio_;
    SketchPad pad_;
    bool isSketching_ = false;
    bool isReversed_ = false;
    double width_ = 5;
};

} // namespace vs::desktop

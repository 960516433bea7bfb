// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/sketch_pad.h"
#include "tools/kinds/cut_tool.h"
#include "tools/kinds/studio_tool.h"

namespace vs::desktop {

// A tool that is drawn with: a press begins a sketch of the shape that the hand is set to, the pen leads it,
// and it ends when the pen is lifted; a polyline goes on from press to press (SketchPad). What then becomes
// of it is up to the subclass. `Base` is what else the tool is: a StudioTool, or one that cuts.
template <class Base>
class SketchTool : public Base {
public:
    explicit SketchTool(StudioController& studio, SketchPad::Needs needs = SketchPad::Needs::Area)
        : Base(studio), needs_(needs) {}

    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override { this->move(pen); } // between a polyline's corners
    bool accept() override;                                  // a polyline ends
    void clear() override;
    void viewResized() override { this->clear(); }
    [[nodiscard]] bool isBusy() const override { return isDrawing_; }
    [[nodiscard]] bool isSketching() const override { return isDrawing_; }

protected:
    // The sketch has ended, and is of use. One that is of none is cleared instead.
    virtual void takeSketch() = 0;

    // What the next sketch takes to be of use.
    void setNeeds(SketchPad::Needs needs) { needs_ = needs; }
    // The sketch in hand, or the last one.
    [[nodiscard]] const SketchPad& pad() const { return pad_; }
    // The sketch as an operation has it.
    [[nodiscard]] studio::Sketch sketch() const;

private:
    void end();

    SketchPad pad_;
    SketchPad::Needs needs_;
    bool isDrawing_ = false;
};

extern template class SketchTool<StudioTool>;
extern template class SketchTool<CutTool>;

} // namespace vs::desktop

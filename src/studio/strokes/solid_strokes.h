// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/strokes/cut_stroke.h"

namespace vs::studio {

// The scissors: a closed stroke cut along the view's rays.
class ScissorsStroke : public CutStroke {
public:
    // `operation` has its canvas set; `makeFrame` gives its frame.
    ScissorsStroke(Cutter& cutter, const MakeFrame& makeFrame, const Scissors& operation);
    void replay() override;

private:
    void limitDepth(sculpt::Extrusion& solid, double depthSteps);

    render::Frame frame_;
    std::vector<float> beginMm_; // along each pixel's ray, with a depth
    std::vector<float> endMm_;
};

// A clip box and clip planes. Live: clipTo() shows another clip, in place of the one before.
class ClipStroke : public CutStroke {
public:
    ClipStroke(Cutter& cutter, const Clip& operation) : CutStroke(cutter, operation, operation.restores) {}
    // `clip` must restore or cut as the first one does.
    void clipTo(const Clip& clip);
    void replay() override { clipTo(std::get<Clip>(operation_)); }
};

} // namespace vs::studio

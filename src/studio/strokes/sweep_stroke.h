// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/strokes/cut_stroke.h"

namespace vs::studio {

// A mask swept along a path through the volume.
class SweepStroke : public CutStroke {
public:
    // `operation` has its canvas set; `makeFrame` gives its frame.
    SweepStroke(Cutter& cutter, const MakeFrame& makeFrame, const Sweep& operation)
        : CutStroke(cutter, operation, operation.restores), frame_(makeFrame()) {}
    void replay() override;

private:
    render::Frame frame_;
};

// The outlines of a sweep's mask at its path's ends and here and there between, in pixels: its preview. Empty
// when the path leads nowhere.
std::vector<std::vector<glm::dvec2>> sweptOutlines(Cutter& cutter, const render::Frame& frame,
                                                   const Sweep& operation);

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/surface/layered_cut.h"
#include "studio/strokes/cut_stroke.h"
#include "studio/strokes/tool_mask.h"

#include <optional>

namespace vs::studio {

// One stroke of the peel. Its mask stays where it was drawn, on the surface seen at pen-down
// (doc/behaviour.md, "Tools"; thesis, section 4.4).
class PeelStroke : public CutStroke {
public:
    // `operation` has its canvas set; `makeFrame` gives its frame.
    PeelStroke(Cutter& cutter, const MakeFrame& makeFrame, const Peel& operation);

    // Peels down to this many layers in all; fewer than before puts layers back.
    void peelTo(double layers);
    void replay() override { peelTo(std::get<Peel>(operation_).layers); }

private:
    void restoreTo(const Peel& op);

    render::Frame frame_;
    ToolMask mask_;
    std::vector<field::SurfacePoint> surface_;
    std::optional<sculpt::LayeredCut> layers_; // of a cut
    std::vector<glm::vec3> directions_;        // of a restore
};

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/strokes/cut_stroke.h"
#include "studio/strokes/stroke_raster.h"
#include "studio/strokes/tool_mask.h"

#include <optional>

namespace vs::studio {

// The plane of a mask that lies on the surface, for the laser: its centre, and how a pixel to the right and
// one down of the drawn mask lie on it (world, mm), and the plane's unit normal, towards the viewer.
struct MaskPlane {
    glm::dvec3 centre{0};
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 down{0, 1, 0};
    glm::dvec3 normal{0, 0, 1};

    [[nodiscard]] glm::dvec3 place(glm::dvec2 pixels) const {
        return centre + pixels.x * right + pixels.y * down;
    }
};

// Lays a mask on the surface seen under a pixel, turned to its normal, which is smoothed over the mask's
// scale. Nothing where the pixel meets nothing.
std::optional<MaskPlane> layOnSurface(Cutter& cutter, const render::Frame& frame, const ToolMask& mask,
                                      glm::dvec2 pixel);

// One stroke of the drill or the laser, from pen-down to pen-up. Surfaces are those seen at pen-down: going
// slower, or over the same place again, cuts no deeper (doc/behaviour.md, "Tools"; thesis, sections 4.3.1
// and 4.3.2); what makes it look again stands in PenCut.
class PenStroke : public CutStroke {
public:
    // `operation` has its canvas set; `makeFrame` gives its frame.
    PenStroke(Cutter& cutter, MakeFrame makeFrame, const Drill& operation);
    PenStroke(Cutter& cutter, MakeFrame makeFrame, const Laser& operation);

    // The pen has come here: cuts all along the way from where it was, as deep as the pressure says.
    void drawAt(const sculpt::PenPoint& pen);
    void replay() override;

private:
    [[nodiscard]] PenCut& cut();
    void detectAgain();
    void goTo(const sculpt::PenPoint& from, const sculpt::PenPoint& to);
    void drill(const sculpt::PenPoint& from, const sculpt::PenPoint& to);
    void burn(const sculpt::PenPoint& from, const sculpt::PenPoint& to);
    void sweep(std::span<const field::SurfacePoint> surface, const sculpt::MaskRaster& mask,
               std::span<const float> depths, sculpt::ToolCut& tool);
    [[nodiscard]] double depthOf(const sculpt::PenPoint& pen);
    [[nodiscard]] glm::dvec3 drillDirection(glm::dvec2 pixel, glm::dvec2 tiltDegrees) const;

    MakeFrame makeFrame_;
    render::Frame frame_;
    ToolMask mask_;
    std::vector<std::uint16_t> flat_; // of the mask: sculpt::flatness()
    StrokeRaster covered_;            // by the drill, since it last looked at the surface
    sculpt::Stroke toReplay_;
};

} // namespace vs::studio

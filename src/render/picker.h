// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "render/ray_caster.h"

#include <span>

namespace vs::render {

// Finds what lies under places of the picture: the surface, or in MIP mode the greatest value. Same rays,
// same surface as the picture shows.
class Picker {
public:
    // In overlay mode the segments are seen through the rest: strokes land on all that has a surface there,
    // what is pointed at is a segment.
    enum class Meets { Everything, SegmentsInOverlay };

    Picker();

    // One surface point for each viewport position (pixels, y down), in order. `frame` says what is drawn and
    // from where; its picture is not touched.
    field::SurfacePoints pick(const Frame& frame, std::span<const glm::vec2> positions,
                              Meets meets = Meets::Everything);

    // As above, read back.
    std::vector<field::SurfacePoint> pickPoints(const Frame& frame, std::span<const glm::vec2> positions,
                                                Meets meets = Meets::Everything);

private:
    gl::Program& programFor(const Frame& frame, Meets meets);

    std::map<int, gl::Program> programs_;
    gl::Buffer view_;
    gl::Buffer positions_;
    field::SceneBinding sceneBinding_;
};

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "render/rays/ray_caster.h"

#include <span>

namespace vs::render {

// Finds what lies under places of the picture: the first visible surface, or what a person points at. Same
// rays, same surface as the picture shows.
class Picker {
public:
    // What a ray meets. Surface: the first visible surface, in every mode, where tools begin. Brightest: in
    // MIP the place of the greatest value instead, which is what is seen there. Segment: as Brightest, and in
    // overlay mode, where segments are seen through the rest, the first segment.
    enum class Meets { Surface, Brightest, Segment };

    Picker();

    // One surface point for each viewport position (pixels, y down), in order. `frame` says what is drawn and
    // from where; its picture is not touched. Where it has finer levels, points are looked for in the finest,
    // and bricks of that are waited for; where those cannot be had, or there is no room for those of a few
    // points, in the scene.
    field::SurfacePoints pick(const Frame& frame, std::span<const glm::vec2> positions,
                              Meets meets = Meets::Surface);

    // Picks as pick() does and reads the points back from the device.
    std::vector<field::SurfacePoint> pickPoints(const Frame& frame, std::span<const glm::vec2> positions,
                                                Meets meets = Meets::Surface);

private:
    struct Asked;
    void pickSome(const Frame& frame, const Asked& asked);
    void pickInBricks(const Frame& frame, const Asked& asked);

    gl::ProgramVariants pickPoints_{"render/shaders/pick_points.comp"};
    gl::Buffer view_;
    gl::Buffer positions_;
    field::SceneBinding sceneBinding_;
};

} // namespace vs::render

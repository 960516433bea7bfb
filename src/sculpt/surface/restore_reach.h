// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/scene.h"
#include "field/surface_points.h"
#include "gl/buffer.h"
#include "gl/program.h"

#include <span>
#include <vector>

namespace vs::sculpt {

// How far what was cut away can be put back on a surface (doc/behaviour.md, "Tools").
class RestoreReach {
public:
    RestoreReach();

    // For each point: how far, in steps, to restore outwards from it (against its unit direction, world), at
    // most its `depths`, through what `scene`'s sculpture has cut away. Where the uncut surface comes before
    // that, its last place in the displayed range and `radius` more, so that its first layer comes back too;
    // 0 where nothing was cut away in front of the point.
    std::vector<float> measure(const field::Scene& scene, std::span<const field::SurfacePoint> points,
                               std::span<const glm::vec3> directions, std::span<const float> depths,
                               int radius);

private:
    gl::Program program_;
    gl::Buffer points_;
    gl::Buffer directions_;
    gl::Buffer reach_;
    field::SceneBinding binding_;
};

} // namespace vs::sculpt

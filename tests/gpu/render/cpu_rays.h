// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/rays.h"
#include "render/camera/camera.h"
#include "render/colours/transfer_function.h"

#include <algorithm>
#include <optional>

namespace vs::test {

// How long a ray's way inside the grid's box is, in mm: voxel borders, not centres; 0 for one that misses the
// box. With `cutAt` the box ends at that voxel coordinate along `axis`.
inline double lengthInBox(const render::ViewRays& rays, glm::dvec2 pixel,
                          const volume::GridGeometry& geometry, int axis = 0,
                          std::optional<double> cutAt = {}) {
    const auto ray = rays.through(pixel);
    glm::dvec3 upper = glm::dvec3(geometry.dims) - 0.5;
    upper[axis] = cutAt.value_or(upper[axis]);
    const Range way = reference::rayThrough(geometry, ray.origin, ray.direction, upper).way;
    return std::max(way.hi - way.lo, 0.0) * geometry.stepMm();
}

// Where the first sample of a pixel's ray lies, as a part of the way between two: the shader's arithmetic
// (cast_rays.comp), for the first sample of a picture.
inline double startJitter(glm::ivec2 pixel) {
    const glm::vec2 place = glm::vec2(pixel) + 64.0F * glm::vec2(0.5F);
    return double(glm::fract(52.9829189F * glm::fract(glm::dot(place, glm::vec2(0.06711056F, 0.00583715F)))));
}

// The rays of a view through a volume, sampled plainly without a device (reference/rays.h).
class CpuRays {
public:
    explicit CpuRays(const volume::Volume& volume) : volume_(volume) {}

    [[nodiscard]] reference::Ray through(const render::ViewRays& rays, glm::dvec2 pixel) const {
        const auto ray = rays.through(pixel);
        return reference::rayThrough(volume_.geometry, ray.origin, ray.direction);
    }
    [[nodiscard]] double greatest(const reference::Ray& ray, double dt) const {
        return reference::greatestAlong(volume_, ray, dt);
    }
    [[nodiscard]] glm::dvec4 composite(const reference::Ray& ray, const render::FunctionSampler& function,
                                       double dt, double jitter) const {
        return reference::compositeAlong(
            volume_, ray, [&](double value, double gradient) { return function.at(value, gradient); }, dt,
            jitter);
    }

private:
    const volume::Volume& volume_;
};

} // namespace vs::test

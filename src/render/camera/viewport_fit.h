// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

namespace vs::render {

// Where the pixels of one viewport are in another through which the same camera looks: what was drawn on the
// one lies over the same things on the other.
class ViewportFit {
public:
    ViewportFit(const Camera& camera, const volume::GridGeometry& geometry, glm::ivec2 from, glm::ivec2 to)
        : scale_(pixelExtent(camera, geometry, from) / pixelExtent(camera, geometry, to)),
          from_(0.5 * glm::dvec2(from)), to_(0.5 * glm::dvec2(to)) {}

    [[nodiscard]] glm::dvec2 operator()(glm::dvec2 pixel) const { return to_ + scale_ * (pixel - from_); }
    // How much larger things are.
    [[nodiscard]] double scale() const { return scale_.y; }

private:
    static glm::dvec2 pixelExtent(const Camera& camera, const volume::GridGeometry& geometry,
                                  glm::ivec2 size) {
        const ViewRays rays = viewRays(camera, geometry, size);
        return glm::dvec2(glm::length(rays.right), glm::length(rays.up)) / (0.5 * glm::dvec2(size));
    }

    glm::dvec2 scale_;
    glm::dvec2 from_; // the middle of each
    glm::dvec2 to_;
};

} // namespace vs::render

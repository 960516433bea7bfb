// SPDX-License-Identifier: Apache-2.0
#include "render/camera/fit.h"

#include "render/camera/orbit.h"

#include <algorithm>

namespace vs::render {

namespace {

// How far points reach along a direction (any length) and against it, from a centre.
struct Reach {
    double along = -1e300;
    double against = -1e300;

    [[nodiscard]] double middle() const { return 0.5 * (along - against); }
    [[nodiscard]] double half() const { return 0.5 * (along + against); }
};

// `depth` is added to both: what lies nearer to the viewer reaches farther towards the picture's border.
Reach reachOf(std::span<const glm::dvec3> points, glm::dvec3 centre, glm::dvec3 direction, glm::dvec3 depth) {
    Reach reach;
    for (const glm::dvec3 point : points) {
        const double across = glm::dot(point - centre, direction);
        const double near = glm::dot(point - centre, depth);
        reach.along = std::max(reach.along, near + across);
        reach.against = std::max(reach.against, near - across);
    }
    return reach;
}

} // namespace

// In perspective, a point p (from the centre, in the viewer's axes) lies between the picture's left and right
// borders when |p.x - pan.x| <= t (d - p.z), for a viewer at the distance d and half a picture's width t per
// distance. All points do for t d >= half of (max(t p.z + p.x) + max(t p.z - p.x)), with half of their
// difference for pan.x; and so for y.
Camera fitted(const Camera& camera, const volume::GridGeometry& geometry, glm::ivec2 size,
              std::span<const glm::dvec3> points, double margin, double mostZoom) {
    if (points.empty()) {
        return camera;
    }
    Camera fit = camera;
    fit.zoom = 1;
    fit.panMm = glm::dvec2(0);
    const ViewRays rays = viewRays(fit, geometry, size);
    const glm::dvec3 centre = geometry.centreWorld();
    const glm::dmat3 axes = viewerAxes(fit);
    const glm::dvec2 half = (1 - 2 * margin) * glm::dvec2(glm::length(rays.right), glm::length(rays.up));
    const bool isPerspective = !rays.isOrthographic;
    const Reach x = reachOf(points, centre, axes[0], isPerspective ? half.x * axes[2] : glm::dvec3(0));
    const Reach y = reachOf(points, centre, axes[1], isPerspective ? half.y * axes[2] : glm::dvec3(0));
    fit.panMm = {x.middle(), y.middle()};
    const double needed = std::max(x.half() / half.x, y.half() / half.y);
    const double atZoom1 = isPerspective ? glm::dot(rays.eye - centre, axes[2]) : 1;
    fit.zoom = needed > 0 ? std::min(atZoom1 / needed, mostZoom) : mostZoom;
    return fit;
}

} // namespace vs::render

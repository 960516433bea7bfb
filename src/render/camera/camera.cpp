// SPDX-License-Identifier: Apache-2.0
#include "render/camera/camera.h"

#include "render/camera/orbit.h"

#include <cmath>

namespace vs::render {

namespace {

// Vertical field of view: narrow, as in medical illustration, so that shapes are not distorted.
constexpr double kHalfFov = 13.0 * 3.14159265358979323846 / 180.0;
// Part of the grid's half diagonal that zoom 1 fits into the smaller side of the picture. Scans seldom fill
// the corners of their box, and a tighter fit would cut the corners off only where there is nothing.
constexpr double kFrame = 0.78;

} // namespace

ViewRays viewRays(const Camera& camera, const volume::GridGeometry& geometry, glm::ivec2 size) {
    const glm::dmat3 axes = viewerAxes(camera);
    const glm::dvec3& right = axes[0];
    const glm::dvec3& up = axes[1];
    const glm::dvec3& toEye = axes[2];

    const double aspect = double(size.x) / double(size.y);
    const double radius = kFrame * 0.5 * geometry.diagonalMm() / camera.zoom;
    const double halfHeight = radius / std::min(1.0, aspect);
    const double distance = halfHeight / std::tan(kHalfFov);
    const glm::dvec3 target = geometry.centreWorld() + camera.panMm.x * right + camera.panMm.y * up;

    ViewRays rays;
    rays.forward = -toEye;
    rays.size = size;
    rays.isOrthographic = camera.projection == Projection::Orthographic;
    // Orthographic rays start well outside the volume, whatever the zoom.
    rays.eye = target + toEye * (rays.isOrthographic ? 4 * geometry.diagonalMm() : distance);
    const double scale = rays.isOrthographic ? halfHeight : halfHeight / distance;
    rays.up = up * scale;
    rays.right = right * scale * aspect;
    return rays;
}

ViewRays::Ray ViewRays::through(glm::dvec2 pixel) const {
    const glm::dvec2 n = 2.0 * pixel / glm::dvec2(size) - 1.0;
    const glm::dvec3 offset = n.x * right - n.y * up;
    if (isOrthographic) {
        return {eye + offset, forward};
    }
    return {eye, glm::normalize(forward + offset)};
}

glm::dvec2 ViewRays::project(glm::dvec3 world) const {
    const glm::dvec3 d = world - eye;
    const double scale = isOrthographic ? 1.0 : glm::dot(d, forward);
    const glm::dvec2 n{glm::dot(d, right) / (glm::dot(right, right) * scale),
                       -glm::dot(d, up) / (glm::dot(up, up) * scale)};
    return 0.5 * (n + 1.0) * glm::dvec2(size);
}

Box2 pixelsAround(const Box3& voxels, const ViewRays& rays, const volume::GridGeometry& geometry) {
    const Box2 whole{glm::ivec2(0), rays.size};
    if (voxels.isEmpty()) {
        return {};
    }
    const glm::dvec3 corners[2] = {glm::dvec3(voxels.lo) - 0.5, glm::dvec3(voxels.hi) - 0.5};
    glm::dvec2 lo(1e30);
    glm::dvec2 hi(-1e30);
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(corners[i & 1].x, corners[i >> 1 & 1].y, corners[i >> 2].z);
        const glm::dvec3 world = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(corner, 1.0));
        if (!rays.isOrthographic && glm::dot(world - rays.eye, rays.forward) < geometry.stepMm()) {
            return whole;
        }
        const glm::dvec2 pixel = rays.project(world);
        lo = glm::min(lo, pixel);
        hi = glm::max(hi, pixel);
    }
    const glm::dvec2 most(rays.size); // what lies far outside is no whole number any more
    lo = glm::clamp(lo, glm::dvec2(0), most);
    hi = glm::clamp(hi, glm::dvec2(0), most);
    return {glm::ivec2(glm::floor(lo)), glm::ivec2(glm::ceil(hi))};
}

double leastPixelMm(const ViewRays& rays, const volume::GridGeometry& geometry) {
    const glm::dvec3 corners[2] = {glm::dvec3(-0.5), glm::dvec3(geometry.dims) - 0.5};
    double least = 1e300;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(corners[i & 1].x, corners[i >> 1 & 1].y, corners[i >> 2].z);
        least = std::min(least, rays.pixelMm(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(corner, 1.0))));
    }
    return least;
}

glm::dvec2 ViewRays::pixelWidths() const {
    const double width = 2 * glm::length(right) / size.x;
    return isOrthographic ? glm::dvec2(width, 0) : glm::dvec2(0, width);
}

double ViewRays::pixelMm(glm::dvec3 world) const {
    const double perUnit = 2 * glm::length(up) / size.y;
    return isOrthographic ? perUnit : perUnit * std::max(glm::dot(world - eye, forward), 1e-12);
}

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#include "render/camera/placement.h"

#include <glm/gtc/matrix_transform.hpp>

namespace vs::render {

namespace {

glm::dmat3 turned(const glm::dvec3& degrees) {
    const double angle = glm::length(degrees);
    return angle > 0 ? glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(angle), degrees / angle))
                     : glm::dmat3(1);
}

// From the grid's centre to where a point of a part lies: world, mm.
glm::dvec3 fromCentre(const Placement& placement, glm::dvec3 voxel, const volume::GridGeometry& geometry) {
    const glm::dmat4 worldFromVoxel = worldFromPart(placement, geometry) * geometry.worldFromVoxel;
    return glm::dvec3(worldFromVoxel * glm::dvec4(voxel, 1)) - geometry.centreWorld();
}

} // namespace

glm::dmat4 worldFromPart(const Placement& placement, const volume::GridGeometry& geometry) {
    const glm::dvec3 centre = geometry.centreWorld();
    const glm::dmat4 there = glm::translate(glm::dmat4(1), centre + placement.moveMm);
    const glm::dmat4 back = glm::translate(glm::dmat4(1), -centre);
    return there * glm::dmat4(turned(placement.turnDegrees) * placement.scale) * back;
}

Placement spreadOut(const Placement& placement, double spread, glm::dvec3 middleVoxel,
                    const volume::GridGeometry& geometry) {
    Placement drawn = placement;
    drawn.moveMm += spread * fromCentre(placement, middleVoxel, geometry);
    return drawn;
}

Placement broughtTogether(const Placement& drawn, double spread, glm::dvec3 middleVoxel,
                          const volume::GridGeometry& geometry) {
    Placement placement = drawn;
    placement.moveMm -= spread / (1 + spread) * fromCentre(drawn, middleVoxel, geometry);
    return placement;
}

ViewRays seenFromPart(const ViewRays& rays, const Placement& placement,
                      const volume::GridGeometry& geometry) {
    const glm::dmat3 unturned = glm::transpose(turned(placement.turnDegrees));
    ViewRays out = rays;
    out.eye = glm::dvec3(glm::inverse(worldFromPart(placement, geometry)) * glm::dvec4(rays.eye, 1));
    out.forward = unturned * rays.forward;
    // An orthographic picture's width is a length; a perspective one's, per unit of distance, is not.
    const double lengths = rays.isOrthographic ? 1 / placement.scale : 1;
    out.right = unturned * rays.right * lengths;
    out.up = unturned * rays.up * lengths;
    return out;
}

} // namespace vs::render

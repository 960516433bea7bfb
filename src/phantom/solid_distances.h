// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <algorithm>

// Signed distances to simple solids, negative inside, exact to first order at their surfaces: what phantoms
// are made of. All lengths in one unit, mm for the phantoms.
namespace vs::phantom {

// An axis-aligned ellipsoid around the origin.
inline double ellipsoidDistance(glm::dvec3 p, glm::dvec3 radii) {
    const double f = glm::length(p / radii);
    const double slope = glm::length(p / (radii * radii));
    return slope > 0 ? f * (f - 1) / slope : -std::min({radii.x, radii.y, radii.z});
}

// An endless cylinder around an axis of coordinates; `p` is what lies across it.
inline double ellipseDistance(glm::dvec2 p, glm::dvec2 radii) {
    const double f = glm::length(p / radii);
    const double slope = glm::length(p / (radii * radii));
    return slope > 0 ? f * (f - 1) / slope : -std::min(radii.x, radii.y);
}

// A ball moved from `a` to `b` while its radius changes evenly.
inline double coneDistance(glm::dvec3 p, glm::dvec3 a, double radiusA, glm::dvec3 b, double radiusB) {
    const glm::dvec3 axis = b - a;
    const double t = std::clamp(glm::dot(p - a, axis) / glm::dot(axis, axis), 0.0, 1.0);
    return glm::length(p - a - t * axis) - glm::mix(radiusA, radiusB, t);
}

// Union and intersection whose seam is rounded over about `width`.
inline double smoothMin(double a, double b, double width) {
    const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * width * overlap * overlap;
}
inline double smoothMax(double a, double b, double width) { return -smoothMin(-a, -b, width); }

} // namespace vs::phantom

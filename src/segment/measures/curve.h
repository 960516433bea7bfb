// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace vs::segment {

// A point of a curve in the world (mm) with the plane across it. The axes of that plane turn from station to
// station no more than the curve itself (Bishop 1975).
struct Station {
    glm::dvec3 place{0};
    glm::dvec3 tangent{0, 0, 1};             // unit
    glm::dvec3 across{1, 0, 0}, up{0, 1, 0}; // the plane's axes: unit, perpendicular to each other
    double alongMm = 0;                      // length of the curve up to here
};

// Stations in equal distances, two at least.
using Curve = std::vector<Station>;

// The plane across a direction (unit) whose first axis lies as close to `across` as it can.
Station stationAcross(const glm::dvec3& place, const glm::dvec3& tangent, const glm::dvec3& across);

// A smooth curve along some places (two at least, mm), from the first to the last, with stations about
// `spacingMm` apart: around each, a parabola is fitted to the places nearby, whose weight falls as a
// Gaussian's of `sigmaMm` along the curve. Arcs stay as wide as they are.
Curve smoothCurve(std::span<const glm::dvec3> places, double sigmaMm, double spacingMm);

// Where along the curve its plane goes through a place, of several such the nearest to the place. Beyond its
// ends the curve goes on straight: less than 0, or more than its length.
double alongNearest(const Curve& curve, const glm::dvec3& place);

// A point of the curve between its stations, or straight on beyond them.
Station stationAt(const Curve& curve, double alongMm);

// The number of the last station before a point of the curve, and the part of the way to the next one that
// lies before it, 0 to 1.
struct Between {
    std::size_t before = 0;
    double part = 0;
};
Between between(const Curve& curve, double alongMm);

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace vs::sculpt {

// A closed polygon (the last point joins the first), in pixels for drawn masks and in steps for sweeps.
using Outline = std::vector<glm::dvec2>;

// A drawn closed curve as it is; consecutive equal points are dropped.
Outline freeFormOutline(std::span<const glm::dvec2> points);
Outline ellipseOutline(glm::dvec2 centre, glm::dvec2 radii);
Outline circleOutline(glm::dvec2 centre, double radius);
// A rectangle; `a` and `b` are opposite corners.
Outline rectangleOutline(glm::dvec2 a, glm::dvec2 b);
// A polyline: corners joined by straight lines, closed.
Outline polylineOutline(std::span<const glm::dvec2> corners);
// A star of `points` tips at distance `outer` from the centre, the first in the direction of +y, and as many
// inner corners at distance `inner`, halfway between them.
Outline starOutline(glm::dvec2 centre, double outer, double inner, int points);

// A rectangle of a mask's plane, in the outline's unit.
struct MaskWindow {
    glm::dvec2 lo{1e300}; // nothing
    glm::dvec2 hi{-1e300};

    [[nodiscard]] bool isEmpty() const { return !(lo.x <= hi.x && lo.y <= hi.y); }
    void include(const MaskWindow& other) {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
};
// The rectangle around an outline.
MaskWindow windowAround(const Outline& outline);

// The part of an outline within a box (Sutherland and Hodgman 1974, "Reentrant polygon clipping"); an outline
// that lies within it stays as it is.
Outline clipToBox(Outline outline, glm::dvec2 lo, glm::dvec2 hi);

// Schemes that round an outline's corners.
enum class Subdivision { CubicBSpline, Chaikin };
inline constexpr std::array<const char*, 2> kSubdivisions{"bspline", "chaikin"};
constexpr const auto& namesOf(Subdivision) { return kSubdivisions; }

// Subdivides a closed outline `levels` times, each of which doubles its points: towards the uniform cubic
// B-spline curve (Lane and Riesenfeld 1980) or the quadratic one (Chaikin 1974) that has the outline as its
// control polygon. Throws Error if it would have more than 4 million points.
Outline subdivide(Outline outline, Subdivision scheme, int levels);

} // namespace vs::sculpt

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <span>
#include <vector>

namespace vs::reference {

// Curves as they are defined, apart from how the program makes paths of them.

// A helix about the line from `from` to `to`, starting beside `from` in the direction of `first` (unit,
// across the line) and turning right-handed; t from 0 to 1.
glm::dvec3 helixAt(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& first, double radius,
                   double turns, double t);
// The centripetal Catmull-Rom spline by the pyramid of Barry and Goldman 1988, t from 0 at the first point to
// 1 at the last, the same for each piece; beyond its ends the mirror images of the second and last but one.
glm::dvec3 centripetalAt(std::span<const glm::dvec3> points, double t);

// A curve with the frames of a mask on it, from many samples and their differences.
class SweptCurve {
public:
    enum class Turning { Least, Normal }; // parallel transport, Frenet

    // `at` for t from 0 to 1. The first frame's x under Turning::Least is the first axis made perpendicular.
    SweptCurve(const std::function<glm::dvec3(double)>& at, Turning turning);

    // The place on the curve whose normal plane a point lies in (the closest of the whole curve), and the
    // point's coordinates in the frame there.
    struct Located {
        glm::dvec2 element{0};
        double fromStart = 0; // lengths along the curve, beyond its ends negative
        double toEnd = 0;
        glm::dvec3 x{0};
        glm::dvec3 y{0};
    };
    [[nodiscard]] Located locate(const glm::dvec3& p) const;

private:
    struct Sample {
        glm::dvec3 point{0};
        glm::dvec3 tangent{0};
        glm::dvec3 x{0};
        double length = 0; // from the start
    };
    std::vector<Sample> samples_;
};

// Distance of a point from a closed polygon, negative inside (even-odd), with the unit normal there, which
// points outwards, and the distance to the nearest corner that turns by more than 0.2 radians.
struct OutlineDistance {
    double distance = 0;
    glm::dvec2 normal{0};
    double toCorner = 1e30;
};
OutlineDistance distanceTo(std::span<const glm::dvec2> polygon, const glm::dvec2& p);

// An ellipse about the origin as a polygon of 2048 corners.
std::vector<glm::dvec2> ellipse(const glm::dvec2& radii);

} // namespace vs::reference

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace vs::sculpt {

// Where a mask is and how it is turned: element (xi, eta) lies at origin + xi * x + eta * y (thesis 3.5.3,
// equation 3.7).
struct MaskFrame {
    glm::dvec3 origin{0};
    glm::dvec3 x{1, 0, 0};
    glm::dvec3 y{0, 1, 0};

    [[nodiscard]] glm::dvec3 place(glm::dvec2 element) const {
        return origin + element.x * x + element.y * y;
    }
};

// A piece of a path: the mask moves in a straight line, or turns on the spot by a few degrees, from one frame
// to the next.
struct PathPiece {
    MaskFrame from;
    MaskFrame to;
};

// Frames along a polyline by parallel transport: between corners the frame stays as it is, at a corner it
// turns about the axis across both lines. The first frame has its x along the first axis (x, else y) that is
// not along the line, made perpendicular; a line along +z has x = +x, y = +y. Points that coincide count
// once; fewer than two give nothing.
std::vector<PathPiece> polylinePath(std::span<const glm::dvec3> points);

} // namespace vs::sculpt

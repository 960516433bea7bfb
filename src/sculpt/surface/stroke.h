// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace vs::sculpt {

// One report of the pen: where it is in the picture (pixels, the first pixel's centre at (0.5, 0.5)), how
// hard it is pressed (0 hovering .. 1), and how far it leans to the right and towards the person (degrees,
// within 60; 0 upright).
struct PenPoint {
    glm::dvec2 pixel{0};
    double pressure = 1;
    glm::dvec2 tiltDegrees{0};
};

// The pen's way from down to up, unfiltered.
using Stroke = std::vector<PenPoint>;

// Whether a pen that has gone straight from one point to another came by a third, within a pixel and in
// much the same way. A pen that was lifted there looks at the surface anew, so it did not.
bool isOnWay(const PenPoint& point, const PenPoint& from, const PenPoint& to);
// The stroke without the points that the straight way between those that are left passes by.
Stroke straightened(const Stroke& stroke);

} // namespace vs::sculpt

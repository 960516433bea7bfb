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

} // namespace vs::sculpt

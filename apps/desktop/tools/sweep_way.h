// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/sweep_tool.h"

#include <glm/glm.hpp>

#include <vector>

namespace vs::desktop {

// The places, a pixel apart, that a way runs through whose corners were set: straight from corner to corner,
// or in a smooth curve through them (sculpt::splinePath). Of a way drawn by hand its points as they are.
std::vector<glm::dvec2> wayThrough(const std::vector<glm::dvec2>& corners, SweepTool::Line line);

} // namespace vs::desktop

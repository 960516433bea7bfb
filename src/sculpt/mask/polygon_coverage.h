// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace vs::sculpt {

// How much of each element's square a polygon covers, exactly, by the even-odd rule: what GL_POLYGON_SMOOTH
// stands for. Element (i, j) is the square of side 1 with its lower corner at (i, j), in the polygon's
// coordinates; x fastest. The polygon is closed and may cross itself.
std::vector<float> polygonCoverage(std::span<const glm::dvec2> polygon, glm::ivec2 size);

} // namespace vs::sculpt

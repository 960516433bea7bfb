// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainterPath>

#include <glm/glm.hpp>

#include <array>

namespace vs::desktop {

class ViewModel;

// The corners of a box in a space of its own, in the world.
std::array<glm::dvec3, 8> boxCorners(glm::dvec3 lo, glm::dvec3 hi, const glm::dmat4& worldFromBox);

// The twelve edges of such a box as they are seen, in logical pixels of the view; those behind the viewer are
// left out.
QPainterPath boxEdges(glm::dvec3 lo, glm::dvec3 hi, const glm::dmat4& worldFromBox, const ViewModel& view);

} // namespace vs::desktop

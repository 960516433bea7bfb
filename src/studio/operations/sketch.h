// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

namespace vs::studio {

// The closed outline of a sketch in viewport pixels; empty if it encloses nothing.
std::vector<glm::dvec2> outlineOf(const Sketch& sketch);

// Centre of the box around an outline.
glm::dvec2 centreOf(const std::vector<glm::dvec2>& outline);

// The viewport pixels (centres, at + 0.5) under seed strokes, each once, row by row: within half the width of
// an open line, inside a closed shape. Pixels outside the viewport are left out.
std::vector<glm::vec2> pixelsUnder(const std::vector<Sketch>& strokes, double widthPixels,
                                   glm::ivec2 viewport);

} // namespace vs::studio

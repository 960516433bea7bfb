// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/program.h"

#include <span>
#include <vector>

namespace vs::studio {

// What a program answers to queries, one for each: shaders/sample_values.comp or classify_values.comp, with
// all else that it needs bound before.
std::vector<glm::vec4> answersOf(gl::Program& program, std::span<const glm::vec4> queries);

} // namespace vs::studio

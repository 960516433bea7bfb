// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <span>
#include <string>
#include <vector>

namespace vs::studio {

// Part of a session that belongs together: what a note tells, up to the next one.
struct Step {
    std::string text;      // of the note; empty for what stands before the first
    std::size_t first = 0; // operation
    std::size_t count = 0; // of operations, the note included
};
std::vector<Step> stepsOf(std::span<const Operation> operations);

} // namespace vs::studio

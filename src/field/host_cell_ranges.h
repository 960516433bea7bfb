// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <glm/vec2.hpp>

#include <vector>

namespace vs::field {

// What computeCellRanges() computes, from a volume of 8- or 16-bit whole numbers on all processors: smallest
// and largest value of each macrocell, in the volume's unit, x fastest. Empty for volumes of other values.
std::vector<glm::vec2> hostCellRanges(const volume::Volume& volume);

} // namespace vs::field

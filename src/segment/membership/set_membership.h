// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_set.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace vs::segment {

// A set as a mask on a box in the grid, x fastest: 1 in the set, 0 not. Nothing: 0 throughout.
using MaskIn = std::function<std::vector<std::uint8_t>(const Box3&)>;

// Whether a set may have voxels in a box, by its bricks.
bool hasAnyIn(const FineSet& set, const Box3& box);

// How much of each voxel in a box belongs to a set, as Segmentation has it for one segment: from 0 to 255, at
// least 128 at the set's voxels, x fastest. Nothing where it is 0 throughout. `spacing`, in mm, is the set's
// grid's; voxels beyond that belong to nobody.
std::vector<std::uint8_t> membershipOf(const FineSet& set, const Box3& box, const glm::dvec3& spacing);
// Threads ask for masks at once.
std::vector<std::uint8_t> membershipOf(const MaskIn& maskIn, glm::ivec3 dims, const Box3& box,
                                       const glm::dvec3& spacing);

} // namespace vs::segment

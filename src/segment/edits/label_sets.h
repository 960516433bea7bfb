// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"

#include <array>
#include <span>

namespace vs::segment {

// The smallest box around the voxels of each label of a grid (x fastest), by label; empty where a label does
// not occur.
std::array<Box3, 256> labelBoxes(std::span<const std::uint8_t> labels, glm::ivec3 dims);

// The voxels of one label within its box.
VoxelSet setOf(std::span<const std::uint8_t> labels, glm::ivec3 dims, std::uint8_t label, const Box3& box);

} // namespace vs::segment

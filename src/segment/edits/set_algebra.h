// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"

namespace vs::segment {

// Voxels of either set.
VoxelSet unite(const VoxelSet& a, const VoxelSet& b);
// Voxels of `a` that are not in `b`.
VoxelSet subtract(const VoxelSet& a, const VoxelSet& b);
// Voxels of both sets.
VoxelSet intersect(const VoxelSet& a, const VoxelSet& b);

} // namespace vs::segment

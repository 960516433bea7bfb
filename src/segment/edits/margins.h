// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "volume/grid/geometry.h"

namespace vs::segment {

// Distances are Euclidean, in mm, between voxel centres, also on sheared grids (segment/edits/nearby.h).
// Outside the grid nothing is in a set, and results are clipped to the grid. All throw Error when a distance
// is not a number, larger than the volume's diagonal or, except for changeMargin, negative.

// Throws that Error.
void checkDistance(const volume::GridGeometry& geometry, double mm);

// Grown (mm > 0): all voxels at most `mm` away from one of the set. Shrunk (mm < 0): what is not in the set
// grows instead, so what remains is more than -mm away from everything outside.
VoxelSet changeMargin(const VoxelSet& set, const volume::GridGeometry& geometry, double mm);

// Shrunk, then grown again: parts in which no ball of this radius fits are gone, the rest is as it was.
VoxelSet opening(const VoxelSet& set, const volume::GridGeometry& geometry, double mm);
// Grown, then shrunk again: gaps in which no ball of this radius fits are closed, the rest is as it was.
VoxelSet closing(const VoxelSet& set, const volume::GridGeometry& geometry, double mm);

// Where the wall of a hollow set lies: within the set, around it, or half and half.
enum class Wall { Inside, Outside, Centred };

// Keeps only a wall of this thickness along the set's surface. A wall outside holds nothing of the set
// itself.
VoxelSet hollow(const VoxelSet& set, const volume::GridGeometry& geometry, double thicknessMm,
                Wall wall = Wall::Inside);

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "volume/grid/geometry.h"

namespace vs::segment {

// How many voxels along each index axis a ball of `mm` reaches from its centre: in sheared grids more than
// its radius over the spacing.
glm::ivec3 reachOf(const volume::GridGeometry& geometry, double mm);

// Whether some index axes are not perpendicular.
bool isSheared(const volume::GridGeometry& geometry);

// The voxels of the set's box with a voxel of the set at most `mm` away, from centre to centre. Exact:
// distances that differ from `mm` by less than a millionth of it count as equal to it, so that rounding does
// not decide. On grids with perpendicular axes by separable minima of parabolas (Saito and Toriwaki 1994,
// "New algorithms for Euclidean distance transformation"), limited to the ball: time goes with voxels times
// reach. On sheared ones by the rows of the ball: voxels times reach squared.
VoxelSet nearby(const VoxelSet& set, const volume::GridGeometry& geometry, double mm);

} // namespace vs::segment

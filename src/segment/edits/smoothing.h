// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "volume/grid/geometry.h"

namespace vs::segment {

// Throws Error unless `mm` lies between 0 and 100 times the largest spacing.
void checkSmoothing(const volume::GridGeometry& geometry, double mm);
// How many voxels along each axis one blur reaches; smooth() blurs twice.
glm::ivec3 smoothingReach(const volume::GridGeometry& geometry, double mm);

// The set without bumps, dents, sheets and gaps thinner than about `mm`, and otherwise where it was. The mask
// is blurred by G, a Gaussian of sigma `mm` along each index axis, and cut at 0.5 after giving back part of
// what blurring takes from curved surfaces: 2 G - G G instead of G, the first step of deconvolution by
// repeated blurring (Van Cittert 1931). A ball of ten times `mm` keeps its radius within 0.5 %, one of five
// times within 2.5 % (with G alone 1 % and 4 % are lost); balls of less than about twice vanish. Depends only
// on what is near; a set that reaches the grid's border goes on beyond it. Throws as checkSmoothing() does.
VoxelSet smooth(const VoxelSet& set, const volume::GridGeometry& geometry, double mm);

} // namespace vs::segment

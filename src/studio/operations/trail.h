// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "segment/finer/fine_set.h"
#include "studio/operations/operation.h"
#include "volume/grid/geometry.h"
#include "volume/grid/volume.h"

namespace vs::studio {

// The voxels of the grid under a trail (Trail says which), in a tight box.
segment::VoxelSet voxelsAlong(const Trail& trail, const volume::GridGeometry& geometry);
// The voxels under a trail that hold a value in the range, where there is one.
segment::VoxelSet voxelsAlong(const Trail& trail, const volume::Volume& volume,
                              const std::optional<Range>& range);

// The voxels of a finer level than the trail's under it: a ball's by their centres, a disc's all of those
// that lie in its slice of the level that the trail is on. `grid` lies in that one's voxel space, and the
// level's voxels lie at `finer`.
segment::FineSet finestAlong(const Trail& trail, const field::BrickGrid& grid,
                             const volume::GridGeometry& finer);

} // namespace vs::studio

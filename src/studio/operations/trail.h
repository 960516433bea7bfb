// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "studio/operations/operation.h"
#include "volume/grid/geometry.h"
#include "volume/grid/volume.h"

namespace vs::studio {

// The voxels of the grid under a trail (Trail says which), in a tight box.
segment::VoxelSet voxelsAlong(const Trail& trail, const volume::GridGeometry& geometry);
// The voxels under a trail that hold a value in the range, where there is one.
segment::VoxelSet voxelsAlong(const Trail& trail, const volume::Volume& volume,
                              const std::optional<Range>& range);

} // namespace vs::studio

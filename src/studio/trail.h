// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/voxel_set.h"
#include "studio/operation.h"
#include "volume/geometry.h"

namespace vs::studio {

// The voxels of the grid under a trail (Trail says which), in a tight box.
segment::VoxelSet voxelsAlong(const Trail& trail, const volume::GridGeometry& geometry);

} // namespace vs::studio

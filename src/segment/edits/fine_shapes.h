// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_set.h"
#include "volume/grid/geometry.h"

namespace vs::segment {

// The edits of margins.h and smoothing.h of sets in grids of any size, with the same results voxel by voxel:
// they depend only on what is near, and are done on pieces of the grid one after the other. `geometry` is the
// grid's. Beside the sets themselves they take some 40 MB, where hundreds of voxels count as near up to 800.
// All throw Error as those do, and where what counts as near is more voxels than a piece may have.
FineSet changeMargin(const FineSet& set, const volume::GridGeometry& geometry, double mm);
FineSet opening(const FineSet& set, const volume::GridGeometry& geometry, double mm);
FineSet closing(const FineSet& set, const volume::GridGeometry& geometry, double mm);
FineSet hollow(const FineSet& set, const volume::GridGeometry& geometry, double thicknessMm);
FineSet smooth(const FineSet& set, const volume::GridGeometry& geometry, double mm);

} // namespace vs::segment

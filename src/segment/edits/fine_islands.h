// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_set.h"
#include "segment/growth/constraints.h"
#include "volume/grid/geometry.h"

#include <limits>

namespace vs::segment {

// The edits of islands.h of sets in grids of any size, with the same results. They go through the rows of
// voxels that lie side by side, some fifty bytes each.

// Keeps only the island at `place`, or everything but that island: the one with the voxel nearest to it, in
// voxels, in the box that reaches so far along each axis. Throws Error when there is none.
FineSet keepIsland(const FineSet& set, glm::ivec3 place, Connectivity connectivity, glm::ivec3 reach);
FineSet dropIsland(const FineSet& set, glm::ivec3 place, Connectivity connectivity, glm::ivec3 reach);

// Keeps only the island with the most voxels, of equal ones that whose first voxel comes first (by z, y, x).
FineSet keepLargestIsland(const FineSet& set, Connectivity connectivity);

// Keeps everything but islands of less than `minimumMl` millilitres.
FineSet dropSmallIslands(const FineSet& set, const volume::GridGeometry& geometry, double minimumMl,
                         Connectivity connectivity);

// The set with its holes of no more than `largestMl` millilitres. Outside the grid is outside.
FineSet fillHoles(const FineSet& set, const volume::GridGeometry& geometry,
                  double largestMl = std::numeric_limits<double>::infinity(),
                  Connectivity connectivity = Connectivity::Six);

} // namespace vs::segment

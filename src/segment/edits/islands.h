// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "segment/growth/constraints.h"
#include "volume/grid/geometry.h"

#include <limits>

namespace vs::segment {

// A largest connected part of a set.
struct Island {
    std::size_t voxels = 0;
    glm::ivec3 first{0}; // its first voxel by z, then y, then x: names the island
    bool operator==(const Island&) const = default;
};

// All islands, the largest first; those of equal size by their first voxel.
std::vector<Island> islands(const VoxelSet& set, Connectivity connectivity = Connectivity::Six);

// How far from a set, in voxels, a place may lie and still mean its nearest island: clicks land on the
// smoothed surface, not in the set.
inline constexpr int kIslandReach = 3;

// Keeps only the island at `voxel`, or everything but that island. The island is the one with the voxel
// nearest to `voxel`, at most kIslandReach voxels away. Throws Error when there is none.
VoxelSet keepIsland(const VoxelSet& set, glm::ivec3 voxel, Connectivity connectivity = Connectivity::Six);
VoxelSet dropIsland(const VoxelSet& set, glm::ivec3 voxel, Connectivity connectivity = Connectivity::Six);

// Keeps only the island with the most voxels.
VoxelSet keepLargestIsland(const VoxelSet& set, Connectivity connectivity = Connectivity::Six);

// Keeps everything but islands of less than `minimumMl` millilitres.
VoxelSet dropSmallIslands(const VoxelSet& set, const volume::GridGeometry& geometry, double minimumMl,
                          Connectivity connectivity = Connectivity::Six);

// The set with its holes: islands of what is not in it that are cut off from the outside, and no larger than
// `largestMl` millilitres. `connectivity` says how these connect: across faces only, a hole that leaks by
// edges or corners alone is closed too. Outside the grid is outside.
VoxelSet fillHoles(const VoxelSet& set, const volume::GridGeometry& geometry,
                   double largestMl = std::numeric_limits<double>::infinity(),
                   Connectivity connectivity = Connectivity::Six);

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/connected_voxels.h"
#include "volume/grid/geometry.h"

#include <optional>
#include <vector>

namespace vs::segment {

// How far each voxel of a piece is from the nearest voxel outside of it, from centre to centre in mm, by its
// number. By offsets to the nearest voxel that are handed on from neighbour to neighbour, there and back: in
// any grid, and too large by some hundredths where handing on misses a nearer one.
std::vector<float> clearancesMm(const ConnectedVoxels& piece, const volume::GridGeometry& geometry);

// A way through a piece from voxel to voxel.
struct VesselPath {
    std::vector<glm::ivec3> voxels;  // neighbours (26), both ends among them
    std::vector<double> clearanceMm; // of each
};

// The way from voxel to voxel (both of the piece) on which the sum of length / clearance^2 is least. It keeps
// to the middle, prefers wide ways to thin ones (of double the width also where they are up to four times as
// long), so that it does not slip through where two vessels barely touch. Of ways that cost the same it is
// always the same one.
VesselPath pathBetween(const ConnectedVoxels& piece, const volume::GridGeometry& geometry, glm::ivec3 from,
                       glm::ivec3 to);

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/curve.h"
#include "segment/measures/lumen.h"

#include <vector>

namespace vs::segment {

// A voxel near the wall of a vessel, seen from the axis.
struct WallVoxel {
    double alongMm = 0;          // where the plane across the axis goes through its centre
    double radiusMm = 0;         // from the axis
    double cosine = 1, sine = 0; // of its angle in that plane
    bool isInside = false;
};

// The voxels near the wall between each two stations of a curve: element i has those from station i to before
// the next one. Left out are voxels in directions where a branch goes off, what lies behind the wall, what is
// beyond the vessel's ends, and what is outside the grid, of which nothing is known.
std::vector<std::vector<WallVoxel>> wallVoxels(const Lumen& lumen, const Curve& curve,
                                               const std::vector<double>& radiiMm);

} // namespace vs::segment

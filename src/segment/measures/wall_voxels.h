// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/curve.h"
#include "segment/measures/lumen.h"

#include <limits>
#include <vector>

namespace vs::segment {

// A voxel near the wall of a vessel, seen from the axis.
struct WallVoxel {
    double alongMm = 0;          // where the plane across the axis goes through its centre
    double radiusMm = 0;         // from the axis
    double cosine = 1, sine = 0; // of its angle in that plane
    bool isInside = false;
    glm::ivec3 voxel{0};
    std::size_t ray = 0; // the nearest one (lumen.h)
    // How much of it the scan's values say lies inside, in the mean 0 to 1; NaN where they do not tell.
    double share = std::numeric_limits<double>::quiet_NaN();
};

// What is seen of the wall from the stations of a curve in the middle of the vessel; nothing where a station
// lies outside.
std::vector<Outline> outlinesAlong(const Lumen& lumen, const Curve& curve,
                                   const std::vector<double>& radiiMm);

// The voxels near the wall between each two stations of a curve: element i has those from station i to before
// the next one. Left out are voxels in directions where a branch goes off, what lies behind the wall, what is
// beyond the vessel's ends, and what is outside the grid, of which nothing is known. `outlines` are what is
// seen of the wall from the stations (outlinesAlong()).
using WallVoxels = std::vector<std::vector<WallVoxel>>;
WallVoxels wallVoxels(const Lumen& lumen, const Curve& curve, const std::vector<Outline>& outlines);

} // namespace vs::segment

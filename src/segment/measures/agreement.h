// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/geometry.h"

#include <cstdint>
#include <span>

namespace vs::segment {

// How well a set of voxels agrees with a true one.
//
// Distances run between the sets' border voxels (those with a face towards outside the set or the grid), from
// centre to centre: for each border voxel of one set the exact Euclidean distance in mm to the nearest one of
// the other (Maurer, Qi and Raghavan 2003, by ITK). Axes that are not perpendicular are taken to be.
//
// Two empty sets agree wholly: 1, distances and differences 0. Of one that is empty and one that is not,
// overlaps are 0 and distances infinite; where it is the true one, so is the difference in percent.
struct Agreement {
    double dice = 0;          // 2 |A and B| / (|A| + |B|)
    double jaccard = 0;       // |A and B| / |A or B|
    double hausdorff95Mm = 0; // distance that 95 % of either border do not exceed, the larger of both ways
    double meanSurfaceMm = 0; // mean distance of all border voxels of both
    double volumeDifferenceMl = 0;      // found - true
    double volumeDifferencePercent = 0; // of the true volume
};

// Compares two masks on one grid, x fastest; what is not 0 is inside.
Agreement compare(const volume::GridGeometry& geometry, std::span<const std::uint8_t> found,
                  std::span<const std::uint8_t> truth);

// Only their Dice coefficient, which costs one pass over the voxels.
double dice(glm::ivec3 dims, std::span<const std::uint8_t> found, std::span<const std::uint8_t> truth);

} // namespace vs::segment

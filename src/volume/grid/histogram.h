// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vs::volume {

// Counts of the finite values in volume.usual in `bins` equal bins over it, on all processors.
std::vector<std::uint64_t> histogram(const Volume& volume, int bins);
// Counts those of a part of the voxels, which must lie in the grid.
std::vector<std::uint64_t> histogram(const Volume& volume, const Box3& box, int bins);

// The value that parts a histogram (equal bins over `range`) into background and object: Otsu's threshold,
// the one with the largest variance between the two classes (Otsu 1979, "A threshold selection method from
// gray-level histograms"). Where a gap in the histogram makes many equally good, their middle.
double otsuThreshold(std::span<const std::uint64_t> counts, const Range& range);

} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"

#include <cstdint>
#include <vector>

namespace vs::field {

// Counts of voxels in `bins` (at most 4096) equal bins over field.range, counted on the device. Non-finite
// voxels are left out.
std::vector<std::uint32_t> intensityHistogram(const Field& field, int bins = 256);

// The value below which the given part (0 to 1) of a histogram's voxels lies (equal bins over `range`), as if
// they were evenly spread within each bin.
double percentile(const std::vector<std::uint32_t>& histogram, const Range& range, double part);

// A displayed range that shows something sensible at first: from the threshold between background and object
// (volume::otsuThreshold) up to the largest value.
Range suggestRange(const std::vector<std::uint32_t>& histogram, const Range& range);

} // namespace vs::field

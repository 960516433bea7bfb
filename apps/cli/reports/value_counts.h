// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vs::cli {

// Whether a volume holds whole numbers in a range so narrow that each value can have a count of its own.
bool hasFewValues(const volume::Volume& volume);

// How often each whole number from volume.range.lo to volume.range.hi occurs, for a volume that has few
// values.
std::vector<std::uint64_t> countsPerValue(const volume::Volume& volume);

// Values that all lie a whole number of steps above the smallest: whole numbers, and those that a scanner or
// a file's slope has stretched.
struct SteppedValues {
    double pitch = 1;                  // between neighbours
    std::vector<std::uint64_t> counts; // of volume.range.lo + i * pitch
};

// Counts a volume's values by their steps; nothing if they do not come in steps, or in more than 65536.
std::optional<SteppedValues> countSteps(const volume::Volume& volume);

} // namespace vs::cli

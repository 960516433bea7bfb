// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/volume.h"

#include <cstdint>
#include <vector>

namespace vs::cli {

// Whether a volume holds whole numbers in a range so narrow that each value can have a count of its own.
bool hasFewValues(const volume::Volume& volume);

// How often each whole number from volume.range.lo to volume.range.hi occurs, for a volume that has few
// values.
std::vector<std::uint64_t> countsPerValue(const volume::Volume& volume);

} // namespace vs::cli

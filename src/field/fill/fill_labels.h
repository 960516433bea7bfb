// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/fill/fill.h"

#include <cstdint>
#include <vector>

namespace vs::field {

// The number of the material that fills each voxel of the scan, 0 where none does; x fastest.
std::vector<std::uint8_t> materialLabels(const Fill& fill);

} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/phrase.h"

#include <cstddef>
#include <string>

namespace vs::studio {

// What applying one operation did.
struct Outcome {
    std::string name;
    double milliseconds = 0;
    std::size_t voxelsTouched = 0; // sculpture voxels changed, or voxels grown or taken back
    Phrase message;                // for the status line, one line
};

} // namespace vs::studio

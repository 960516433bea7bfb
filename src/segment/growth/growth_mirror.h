// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace vs::segment {

// A brick of a growth that shows what has grown elsewhere (Growth::mirror()): of each voxel of its box, x
// fastest, the generation (0: none) and the segment.
struct MirroredBrick {
    std::vector<std::uint32_t> generations;
    std::vector<std::uint8_t> labels;
};
// Tells what a brick has now, into lists of whatever length. Threads may ask at once.
using MirrorOf = std::function<void(std::uint32_t brick, MirroredBrick& told)>;

} // namespace vs::segment

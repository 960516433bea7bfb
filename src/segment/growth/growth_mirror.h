// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace vs::segment {

// A brick of a growth that shows what has grown elsewhere (Growth::mirror()): of each voxel of its box, x
// fastest, the generation (0: none) and the segment.
struct MirroredBrick {
    std::uint32_t brick = 0;
    std::vector<std::uint32_t> generations;
    std::vector<std::uint8_t> labels;
};

} // namespace vs::segment

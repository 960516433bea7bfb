// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace vs::segment {

// A brick of a growth that shows what has grown elsewhere (Growth::mirror()): of each voxel of its box, x
// fastest, the segment (0: none) and, where there is one, the generation, which is not 0.
struct MirroredBrick {
    std::vector<std::uint8_t> labels;
    std::vector<std::uint32_t> generations;
};
// Calls f(i) for each voxel that is in a segment. Most bricks have few: eight without any cost one look.
template <typename F>
void forEachLabelled(const std::vector<std::uint8_t>& labels, F&& f) {
    constexpr std::size_t kTogether = sizeof(std::uint64_t);
    for (std::size_t first = 0; first < labels.size(); first += kTogether) {
        const std::size_t end = std::min(first + kTogether, labels.size());
        std::uint64_t together = 0;
        std::memcpy(&together, labels.data() + first, end - first);
        for (std::size_t i = first; together != 0 && i < end; ++i) {
            if (labels[i] != 0) {
                f(i);
            }
        }
    }
}
// Tells what a brick has now, into lists of whatever length. Threads may ask at once.
using MirrorOf = std::function<void(std::uint32_t brick, MirroredBrick& told)>;

} // namespace vs::segment

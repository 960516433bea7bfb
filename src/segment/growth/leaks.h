// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vs::segment {

// The last generations before a region has leaked, in order: where it leaves what it has filled through a
// narrow place, and then grows faster than it would have. `voxels` are those grown by generations 1, 2, ...,
// `begun` is the last generation that got seeds. At most three, those of the greatest jumps.
//
// A region that spreads from its seeds without obstacles gets at most (n + 1)^2 / n^2 times as many voxels a
// generation, and fewer and fewer more as it fills a body without narrow places: there the logarithm of its
// rate is concave. So the rate that an eighth of the generations so far leads to expect for the next ones is
// that of the eighth before them, times its growth since the eighth before that: no more than that of free
// spreading, and no less than 3/5. A leak begins where the rate is twice that, in a region that becomes a
// fifth larger by it at least.
std::vector<int> leaks(std::span<const std::uint64_t> voxels, int begun);

} // namespace vs::segment

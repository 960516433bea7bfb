// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <cstdint>
#include <vector>

namespace vs::segment {

inline constexpr int kBeside = 2; // voxels, as sculpt/shaders/cut_islands.comp has them

// What has to go so that nothing of islands is seen any more, surfaces included, and that of what is kept
// stays as it is: 1 within kBeside voxels of an island, along any axes, but not within one of what is kept, 0
// elsewhere, for the voxels of a box. Both are masks on the box grown by kBeside. All x fastest.
std::vector<float> besideIslands(const std::vector<std::uint8_t>& islands,
                                 const std::vector<std::uint8_t>& kept, const Box3& box);

} // namespace vs::segment

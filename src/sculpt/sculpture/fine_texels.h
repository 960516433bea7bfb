// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture/fine_sculpture.h"

namespace vs::sculpt {

// Copies the part of one box of texels that another one shares with it. Boxes of texels are x fastest.
void copyTexels(const Box3& from, const std::byte* source, const Box3& to, std::byte* target,
                std::size_t texelBytes);

// Texels of a box of a grid, of which these are the bricks; zeros where there are none.
std::vector<std::byte> texelsIn(const FineBricks& bricks, glm::ivec3 dims, std::size_t texelBytes,
                                const Box3& box);

} // namespace vs::sculpt

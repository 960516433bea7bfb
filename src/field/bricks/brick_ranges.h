// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_texels.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vs::field {

// Voxels along each axis of the cells of which it is known what a brick holds; mirrors
// field/shaders/bricks.glsl.
inline constexpr int kBrickCell = 8;

// A smallest and a largest value as one word for shaders: the upper halves of two floats, the smallest in the
// lower 16 bits. Both are rounded outwards, so that nothing lies outside of what the word says.
std::uint32_t rangeWord(float smallest, float largest);
inline constexpr std::uint32_t kAnyValue = 0x7f7fff7fU; // from -3e38 to 3e38: it is not known

// What samples in a brick can have, in the volume's unit.
struct BrickRanges {
    std::uint32_t all = kAnyValue;    // in all of it
    std::vector<std::uint32_t> cells; // in each of its cells, x fastest: cellsAlong() an axis
};

// Cells along each axis of a brick of so many voxels an axis.
constexpr int cellsAlong(int side) { return (side + kBrickCell - 1) / kBrickCell; }

// The ranges of a brick of `side` voxels along each axis, with texels of one voxel more: a cell's samples lie
// between those of its own and the first ones behind them.
BrickRanges rangesOf(std::span<const std::byte> texels, int side, const BrickTexels& meaning);

} // namespace vs::field

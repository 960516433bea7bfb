// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/seed_map.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vs::segment {

// Bytes as undo and files hold them (zstd). decompress() throws Error when that is not what they are, or are
// others than `sizeBytes`.
std::vector<std::byte> compress(const std::vector<std::byte>& bytes);
std::vector<std::byte> decompress(const std::vector<std::byte>& compressed, std::size_t sizeBytes);

// All there is in one brick of a seed map, kept for later.
struct SavedBrick {
    std::uint32_t brick = 0;
    GenerationSpan span;
    std::size_t size = 0; // uncompressed
    std::vector<std::byte> compressed;
};

SavedBrick saved(const SeedMap& seedMap, std::uint32_t brick);
// Puts the brick back, with its span; the seed map's spans are to be uploaded afterwards. Throws Error when
// it is damaged.
void putBack(SeedMap& seedMap, const SavedBrick& brick);

} // namespace vs::segment

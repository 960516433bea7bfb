// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/saved_brick.h"

#include "base/check.h"
#include "base/error.h"

#include <zstd.h>

namespace vs::segment {

namespace {

// Generations of neighbouring voxels differ by one, so even the fastest level shrinks them well.
constexpr int kLevel = 1;

} // namespace

std::vector<std::byte> compress(const std::vector<std::byte>& bytes) {
    std::vector<std::byte> out(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
    VS_CHECK(ZSTD_isError(size) == 0);
    out.resize(size);
    out.shrink_to_fit();
    return out;
}

std::vector<std::byte> decompress(const std::vector<std::byte>& compressed, std::size_t sizeBytes) {
    std::vector<std::byte> out(sizeBytes);
    if (ZSTD_decompress(out.data(), out.size(), compressed.data(), compressed.size()) != sizeBytes) {
        throw Error("what was kept of a segment is damaged");
    }
    return out;
}

SavedBrick saved(const SeedMap& seedMap, std::uint32_t brick) {
    const auto bytes = seedMap.saveBrick(brick);
    return {brick, seedMap.bricks().span(brick), bytes.size(), compress(bytes)};
}

void putBack(SeedMap& seedMap, const SavedBrick& brick) {
    if (brick.brick >= seedMap.bricks().count() || !seedMap.isBrick(brick.brick, brick.size)) {
        throw Error("what was kept of a segment does not fit the volume");
    }
    seedMap.restoreBrick(brick.brick, decompress(brick.compressed, brick.size));
    seedMap.bricks().setSpan(brick.brick, brick.span);
}

} // namespace vs::segment

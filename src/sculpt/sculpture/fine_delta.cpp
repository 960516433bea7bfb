// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "sculpt/sculpture/fine_sculpture.h"

#include <zstd.h>

namespace vs::sculpt {

namespace {

constexpr int kQuickCompression = 1;
constexpr std::size_t kOneTexel = sizeof(float); // at the most

} // namespace

FineBrick packed(const FineBrick& brick) {
    if (brick == nullptr || brick->size() <= kOneTexel) {
        return brick;
    }
    std::vector<std::byte> bytes(ZSTD_compressBound(brick->size()));
    const std::size_t size =
        ZSTD_compress(bytes.data(), bytes.size(), brick->data(), brick->size(), kQuickCompression);
    if (ZSTD_isError(size) != 0U) {
        throw Error("undo data could not be compressed: {}; free some memory", ZSTD_getErrorName(size));
    }
    return std::make_shared<const std::vector<std::byte>>(bytes.begin(),
                                                          bytes.begin() + std::ptrdiff_t(size));
}

FineBrick unpacked(const FineBrick& kept, std::size_t bytes) {
    if (kept == nullptr || kept->size() <= kOneTexel) {
        return kept;
    }
    auto brick = std::make_shared<std::vector<std::byte>>(bytes);
    const std::size_t size = ZSTD_decompress(brick->data(), bytes, kept->data(), kept->size());
    if (size != bytes) {
        throw Error("undo data is damaged: {} bytes instead of {}", size, bytes);
    }
    return brick;
}

std::size_t FineDelta::memoryBytes() const {
    std::size_t bytes = 0;
    for (const auto& [place, brick] : bricks) {
        bytes += brick != nullptr ? brick->size() : 0;
    }
    return bytes;
}

} // namespace vs::sculpt

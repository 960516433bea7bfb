// SPDX-License-Identifier: Apache-2.0
#include "sculpt/brick_backup.h"

#include "base/check.h"
#include "base/error.h"
#include "field/field.h"
#include "gl/pass.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>

namespace vs::sculpt {

namespace {

// Fast rather than small: undo must not be felt, and bricks of a sculpture are mostly runs of equal values.
constexpr int kCompressionLevel = 1;

std::vector<std::byte> compress(const std::vector<std::byte>& bytes) {
    std::vector<std::byte> out(ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kCompressionLevel);
    if (ZSTD_isError(size) != 0U) {
        throw Error("undo data could not be compressed: {}; free some memory", ZSTD_getErrorName(size));
    }
    out.resize(size);
    out.shrink_to_fit();
    return out;
}

std::vector<std::byte> decompress(const std::vector<std::byte>& compressed, std::size_t expected) {
    std::vector<std::byte> out(expected);
    const std::size_t size = ZSTD_decompress(out.data(), out.size(), compressed.data(), compressed.size());
    VS_CHECK_EQ(size, expected);
    return out;
}

std::size_t countDifferences(const std::vector<std::byte>& a, const std::vector<std::byte>& b,
                             std::size_t texel) {
    std::size_t count = 0;
    for (std::size_t n = 0; n < a.size(); n += texel) {
        count += std::memcmp(&a[n], &b[n], texel) != 0 ? 1 : 0;
    }
    return count;
}

} // namespace

void BrickDelta::swap(gl::Texture& texture) {
    const gl::Pass pass("swap bricks");
    for (Brick& brick : bricks_) {
        auto current = texture.download(brick.box);
        auto held = compress(current);
        texture.upload(brick.box, decompress(brick.compressed, current.size()));
        brick.compressed = std::move(held);
    }
}

Box3 BrickDelta::box() const {
    Box3 all;
    for (const Brick& brick : bricks_) {
        all = unite(all, brick.box);
    }
    return all;
}

std::size_t BrickDelta::memoryBytes() const {
    std::size_t bytes = sizeof(*this);
    for (const Brick& brick : bricks_) {
        bytes += sizeof(brick) + brick.compressed.capacity();
    }
    return bytes;
}

void BrickBackup::protect(const Box3& voxels) {
    const Box3 whole{glm::ivec3(0), texture_->size()};
    const Box3 part = intersect(voxels, whole);
    if (part.isEmpty()) {
        return;
    }
    const gl::Pass pass("protect bricks");
    const glm::ivec3 grid = divideUp(texture_->size(), field::kBrick);
    const glm::ivec3 first = part.lo / field::kBrick;
    const glm::ivec3 last = (part.hi - 1) / field::kBrick;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const std::size_t number =
                    (std::size_t(z) * std::size_t(grid.y) + std::size_t(y)) * std::size_t(grid.x) +
                    std::size_t(x);
                if (!originals_.contains(number)) {
                    const glm::ivec3 lo = glm::ivec3(x, y, z) * field::kBrick;
                    const Box3 box = intersect({lo, lo + field::kBrick}, whole);
                    originals_.emplace(number, Original{box, texture_->download(box)});
                }
            }
        }
    }
}

Box3 BrickBackup::restore() {
    const gl::Pass pass("restore bricks");
    Box3 all;
    for (const auto& [number, original] : originals_) {
        texture_->upload(original.box, original.bytes);
        all = unite(all, original.box);
    }
    return all;
}

BrickDelta BrickBackup::finish() {
    const gl::Pass pass("finish bricks");
    BrickDelta delta;
    for (const auto& [number, original] : originals_) {
        const auto current = texture_->download(original.box);
        if (current != original.bytes) {
            delta.changedVoxels_ +=
                countDifferences(current, original.bytes, gl::bytesPerTexel(texture_->format()));
            delta.bricks_.push_back({original.box, compress(original.bytes)});
        }
    }
    originals_.clear();
    return delta;
}

} // namespace vs::sculpt

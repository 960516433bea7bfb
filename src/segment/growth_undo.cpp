// SPDX-License-Identifier: Apache-2.0
#include "segment/growth_undo.h"

#include "base/check.h"

#include <zstd.h>

#include <algorithm>
#include <limits>

namespace vs::segment {

namespace {

// Generations of neighbouring voxels differ by one, so even the fastest level shrinks them well.
constexpr int kLevel = 1;

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
    VS_CHECK_EQ(ZSTD_decompress(out.data(), out.size(), compressed.data(), compressed.size()), sizeBytes);
    return out;
}

} // namespace

void GrowthUndo::begin(const Growth& growth) {
    before_ = growth.state_;
    addedSeeds_.clear();
    saved_.clear();
}

void GrowthUndo::save(const Growth& growth, int last) {
    for (const std::uint32_t brick : growth.bricks_.holding(last, std::numeric_limits<int>::max())) {
        const auto bytes = growth.seedMap_.download(growth.bricks_.box(brick));
        const auto* values = reinterpret_cast<const std::uint32_t*>(bytes.data());
        const bool loses = std::any_of(values, values + bytes.size() / sizeof(std::uint32_t),
                                       [&](std::uint32_t g) { return g > std::uint32_t(last); });
        // A brick that loses nothing may still have too wide a span, which is harmless.
        if (loses) {
            saved_.push_back({brick, growth.bricks_.span(brick), compress(bytes)});
        }
    }
}

void GrowthUndo::undo(Growth& growth) const {
    VS_CHECK_EQ(growth.extent(), extentAfter_);
    // First what the call added: hidden, then erased.
    const int last = std::min(before_.extent, extentAfter_);
    growth.movePlayhead(std::min({growth.playhead(), before_.playhead, last}));
    if (extentAfter_ > last) {
        growth.eraseAfter(last);
    }
    if (!addedSeeds_.empty() && last > 0) {
        growth.storeGeneration(addedSeeds_, 0);
        std::vector<std::uint32_t> touched;
        for (const std::uint32_t voxel : addedSeeds_) {
            touched.push_back(growth.bricks_.brickOf(growth.voxelAt(voxel)));
        }
        growth.bricks_.markChanged(touched);
    }
    // Then what it erased. The saved bricks are whole, so order among them does not matter.
    for (const SavedBrick& saved : saved_) {
        const Box3 box = growth.bricks_.box(saved.brick);
        growth.seedMap_.upload(box, decompress(saved.compressed, box.volume() * sizeof(std::uint32_t)));
        growth.bricks_.setSpan(saved.brick, saved.span);
    }
    growth.bricks_.upload();
    growth.state_.extent = before_.extent;
    growth.movePlayhead(before_.playhead);
    growth.state_ = before_;
    growth.frontier_.invalidate();
}

std::size_t GrowthUndo::bytes() const {
    std::size_t total = sizeof(*this) + addedSeeds_.size() * sizeof(std::uint32_t) +
                        before_.voxels.size() * sizeof(std::uint64_t) + saved_.size() * sizeof(SavedBrick);
    for (const SavedBrick& saved : saved_) {
        total += saved.compressed.size();
    }
    return total;
}

} // namespace vs::segment

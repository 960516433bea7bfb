// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/growth_undo.h"

#include "base/check.h"

#include <zstd.h>

#include <algorithm>

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
    *this = {};
    before_ = growth.state_;
    labelBefore_ = growth.owner_.label;
}

void GrowthUndo::save(const Growth& growth, const std::vector<std::uint32_t>& bricks) {
    for (const std::uint32_t brick : bricks) {
        const auto bytes = growth.seedMap_.saveBrick(brick);
        saved_.push_back({brick, growth.seedMap_.bricks().span(brick), bytes.size(), compress(bytes)});
    }
}

void GrowthUndo::keepForbidden(const Growth& growth) {
    changesForbidden_ = true;
    if (growth.forbidden_) {
        forbidden_ = compress(growth.forbidden_.read<std::byte>(growth.seedMap_.planeBytes()));
    }
}

void GrowthUndo::end(const Growth& growth) {
    extentAfter_ = growth.extent();
    labelAfter_ = growth.owner_.label;
}

void GrowthUndo::undo(Growth& growth) const {
    VS_CHECK_EQ(growth.extent(), extentAfter_);
    VS_CHECK_EQ(int(growth.owner_.label), int(labelAfter_));
    SeedMap& seedMap = growth.seedMap_;
    BrickTable& bricks = seedMap.bricks();
    if (labelBefore_ != labelAfter_) {
        growth.exchangeRun(labelBefore_);
    } else {
        // First what the call added: hidden, then erased.
        const int last = std::min(before_.extent, extentAfter_);
        growth.movePlayhead(std::min({growth.playhead(), before_.playhead, last}));
        if (extentAfter_ > last) {
            growth.eraseAfter(last);
        }
        if (!addedSeeds_.empty()) {
            seedMap.store(addedSeeds_, 0);
            std::vector<std::uint32_t> touched;
            for (const std::uint32_t voxel : addedSeeds_) {
                touched.push_back(bricks.brickOf(seedMap.voxelAt(voxel)));
            }
            bricks.markChanged(touched);
        }
        if (!allowedAgain_.empty()) {
            growth.passes_.setBits(seedMap, growth.forbidden_, allowedAgain_, true);
        }
    }
    // Then what it erased; bricks that were changed twice are last as they were first.
    std::vector<std::uint32_t> restored;
    for (auto saved = saved_.rbegin(); saved != saved_.rend(); ++saved) {
        seedMap.restoreBrick(saved->brick, decompress(saved->compressed, saved->size));
        bricks.setSpan(saved->brick, saved->span);
        restored.push_back(saved->brick);
    }
    bricks.upload();
    bricks.markChanged(restored);
    if (changesForbidden_) {
        growth.forbidden_ = {};
        if (!forbidden_.empty()) {
            growth.forbidden_ = gl::Buffer(seedMap.planeBytes(), "forbidden voxels");
            growth.forbidden_.write(std::span<const std::byte>(decompress(forbidden_, seedMap.planeBytes())));
        }
    }
    growth.state_.extent = before_.extent;
    growth.movePlayhead(before_.playhead);
    growth.state_ = before_;
    growth.frontier_.invalidate();
}

std::size_t GrowthUndo::bytes() const {
    std::size_t total = sizeof(*this) + (addedSeeds_.size() + allowedAgain_.size()) * sizeof(std::uint32_t) +
                        before_.voxels.size() * sizeof(std::uint64_t) + saved_.size() * sizeof(SavedBrick) +
                        forbidden_.size();
    for (const SavedBrick& saved : saved_) {
        total += saved.compressed.size();
    }
    return total;
}

} // namespace vs::segment

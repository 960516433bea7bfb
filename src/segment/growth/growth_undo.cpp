// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/growth_undo.h"

#include "base/check.h"

#include <algorithm>

namespace vs::segment {

void GrowthUndo::begin(const Growth& growth) {
    *this = {};
    held_.before = growth.state_;
    held_.labelBefore = growth.owner_.label;
}

void GrowthUndo::save(const Growth& growth, const std::vector<std::uint32_t>& bricks) {
    for (const std::uint32_t brick : bricks) {
        held_.saved.push_back(segment::saved(growth.seedMap_, brick));
    }
}

void GrowthUndo::keepForbidden(const Growth& growth) {
    held_.changesForbidden = true;
    if (growth.forbidden_) {
        held_.forbidden = compress(growth.forbidden_.read<std::byte>(growth.seedMap_.planeBytes()));
    }
}

void GrowthUndo::end(const Growth& growth) {
    held_.extentAfter = growth.extent();
    held_.labelAfter = growth.owner_.label;
}

void GrowthUndo::undo(Growth& growth) const {
    VS_CHECK_EQ(growth.extent(), held_.extentAfter);
    VS_CHECK_EQ(int(growth.owner_.label), int(held_.labelAfter));
    SeedMap& seedMap = growth.seedMap_;
    BrickTable& bricks = seedMap.bricks();
    if (held_.labelBefore != held_.labelAfter) {
        growth.exchangeRun(held_.labelBefore);
    } else {
        // First what the call added: hidden, then erased.
        const int last = std::min(held_.before.extent, held_.extentAfter);
        growth.movePlayhead(std::min({growth.playhead(), held_.before.playhead, last}));
        if (held_.extentAfter > last) {
            growth.eraseAfter(last);
        }
        if (!held_.addedSeeds.empty()) {
            seedMap.store(held_.addedSeeds, 0);
            std::vector<std::uint32_t> touched;
            for (const std::uint32_t voxel : held_.addedSeeds) {
                touched.push_back(bricks.brickOf(seedMap.voxelAt(voxel)));
            }
            bricks.markChanged(touched);
        }
        if (!held_.allowedAgain.empty()) {
            growth.passes_.setBits(seedMap, growth.forbidden_, held_.allowedAgain, true);
        }
    }
    // Then what it erased; bricks that were changed twice are last as they were first.
    std::vector<std::uint32_t> restored;
    for (auto saved = held_.saved.rbegin(); saved != held_.saved.rend(); ++saved) {
        putBack(seedMap, *saved);
        restored.push_back(saved->brick);
    }
    bricks.upload();
    bricks.markChanged(restored);
    if (held_.changesForbidden) {
        growth.forbidden_ = {};
        if (!held_.forbidden.empty()) {
            growth.forbidden_ = gl::Buffer(seedMap.planeBytes(), "forbidden voxels");
            growth.forbidden_.write(
                std::span<const std::byte>(decompress(held_.forbidden, seedMap.planeBytes())));
        }
    }
    growth.state_.extent = held_.before.extent;
    growth.movePlayhead(held_.before.playhead);
    growth.state_ = held_.before;
    growth.frontier_.invalidate();
}

std::size_t GrowthUndo::bytes() const {
    std::size_t total = sizeof(*this) +
                        (held_.addedSeeds.size() + held_.allowedAgain.size()) * sizeof(std::uint32_t) +
                        held_.before.voxels.size() * sizeof(std::uint64_t) +
                        held_.saved.size() * sizeof(SavedBrick) + held_.forbidden.size();
    for (const SavedBrick& saved : held_.saved) {
        total += saved.compressed.size();
    }
    return total;
}

} // namespace vs::segment

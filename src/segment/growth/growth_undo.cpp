// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/growth_undo.h"

#include "base/check.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace vs::segment {

GrowthUndo::Recording::Recording(GrowthUndo* undo, const Growth& growth)
    : undo_(undo), growth_(&growth), exceptionsBefore_(std::uncaught_exceptions()) {
    if (undo_ != nullptr) {
        *undo_ = {};
        undo_->held_.before = growth.state_;
        undo_->held_.labelBefore = growth.owner_.label;
    }
}

GrowthUndo::Recording::~Recording() {
    if (undo_ != nullptr) {
        undo_->end(*growth_);
        undo_->isInterrupted_ = std::uncaught_exceptions() > exceptionsBefore_;
    }
}

void GrowthUndo::save(const Growth& growth, const std::vector<std::uint32_t>& bricks) {
    for (const std::uint32_t brick : bricks) {
        held_.saved.push_back(segment::saved(growth.seedMap_, brick));
    }
}

void GrowthUndo::keepForbidden(const Growth& growth) {
    if (growth.forbidden_) {
        held_.forbidden = compress(growth.forbidden_.read<std::byte>(growth.seedMap_.planeBytes()));
    }
    held_.changesForbidden = true;
}

void GrowthUndo::end(const Growth& growth) noexcept {
    held_.extentAfter = growth.extent();
    held_.labelAfter = growth.owner_.label;
}

void GrowthUndo::undo(Growth& growth) const {
    if (held_.labelBefore == 0) {
        return;
    }
    VS_CHECK(growth.owner_.label == held_.labelAfter || growth.owner_.label == held_.labelBefore);
    GrowthState before = held_.before;
    growth.frontier_->invalidate();
    if (held_.labelBefore != growth.owner_.label) {
        growth.exchangeRun(held_.labelBefore);
    } else if (held_.labelBefore == held_.labelAfter) {
        eraseAdded(growth);
    }
    putBackErased(growth);
    growth.movePlayhead(held_.before.playhead);
    growth.state_ = std::move(before);
}

// What the call added: hidden, then erased.
void GrowthUndo::eraseAdded(Growth& growth) const {
    SeedMap& seedMap = growth.seedMap_;
    VS_CHECK(growth.extent() == held_.extentAfter || growth.extent() == held_.before.extent);
    const int last = std::min(held_.before.extent, held_.extentAfter);
    growth.movePlayhead(std::min({growth.playhead(), held_.before.playhead, last}));
    if (isInterrupted_) {
        seedMap.bricks().download(); // the device may have written more than was read
    }
    if (isInterrupted_ || held_.extentAfter > last) {
        growth.eraseAfter(last);
    }
    if (!held_.addedSeeds.empty()) {
        std::vector<std::uint32_t> touched;
        for (const std::uint32_t voxel : held_.addedSeeds) {
            touched.push_back(seedMap.bricks().brickOf(seedMap.voxelAt(voxel)));
        }
        seedMap.store(held_.addedSeeds, 0);
        seedMap.bricks().markChanged(touched);
    }
    if (!held_.allowedAgain.empty()) {
        growth.passes_.setBits(seedMap, growth.forbidden_, held_.allowedAgain, true);
    }
}

// What the call erased; bricks that were changed twice are last as they were first.
void GrowthUndo::putBackErased(Growth& growth) const {
    SeedMap& seedMap = growth.seedMap_;
    std::vector<std::uint32_t> restored;
    for (auto saved = held_.saved.rbegin(); saved != held_.saved.rend(); ++saved) {
        restored.push_back(saved->brick);
        putBack(seedMap, *saved);
    }
    seedMap.bricks().upload();
    seedMap.bricks().markChanged(restored);
    if (held_.changesForbidden) {
        gl::Buffer forbidden;
        if (!held_.forbidden.empty()) {
            forbidden = seedMap.makePlane("forbidden voxels");
            forbidden.write(std::span<const std::byte>(decompress(held_.forbidden, seedMap.planeBytes())));
        }
        growth.forbidden_ = std::move(forbidden);
    }
    growth.state_.extent = held_.before.extent;
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

// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/growth_snapshot.h"

#include "base/check.h"
#include "base/error.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace vs::segment {

GrowthSnapshot Growth::snapshot() const {
    syncLabels();
    GrowthSnapshot all;
    all.label = owner_.label;
    all.atWork.state = state_;
    if (forbidden_) {
        all.atWork.forbidden = compress(forbidden_.read<std::byte>(seedMap_.planeBytes()));
    }
    for (const auto& [label, run] : others_) {
        const auto bytes = std::as_bytes(std::span(run.forbidden));
        all.others[label] = {run.state, run.spans,
                             bytes.empty() ? std::vector<std::byte>()
                                           : compress({bytes.begin(), bytes.end()})};
    }
    for (const std::uint32_t brick : seedMap_.bricks().occupied()) {
        all.bricks.push_back(saved(seedMap_, brick));
    }
    return all;
}

void Growth::restore(const GrowthSnapshot& all) {
    VS_CHECK_EQ(revision(), std::uint64_t(0));
    BrickTable& bricks = seedMap_.bricks();
    std::vector<std::uint32_t> touched;
    for (const SavedBrick& brick : all.bricks) {
        putBack(seedMap_, brick);
        touched.push_back(brick.brick);
    }
    bricks.occupy(touched);
    bricks.upload();
    bricks.markChanged(touched);
    state_ = all.atWork.state;
    if (!all.atWork.forbidden.empty()) {
        forbidden_ = seedMap_.makePlane("forbidden voxels");
        forbidden_.write(std::span<const std::byte>(decompress(all.atWork.forbidden, seedMap_.planeBytes())));
    }
    for (const auto& [label, run] : all.others) {
        others_[label] = {run.state, run.spans, {}};
        if (!run.forbidden.empty()) {
            const auto bytes = decompress(run.forbidden, seedMap_.planeBytes());
            others_[label].forbidden.resize(bytes.size() / sizeof(std::uint32_t));
            std::memcpy(others_[label].forbidden.data(), bytes.data(), bytes.size());
        }
    }
    owner_ = {all.label, hasGrownOthers()};
    frontier_->invalidate();
}

} // namespace vs::segment

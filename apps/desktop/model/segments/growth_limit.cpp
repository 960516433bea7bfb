// SPDX-License-Identifier: Apache-2.0
#include "model/segments/growth_limit.h"

#include "segment/growth/growth.h"

#include <algorithm>

namespace vs::desktop {

void GrowthLimit::hold(std::uint8_t label, double displayedVoxels) {
    held_.reset();
    if (percent_ > 0) {
        held_ = Of{label, std::uint64_t(std::max(1.0, displayedVoxels * percent_ / 100))};
    }
}

std::uint64_t GrowthLimit::mostVoxels(std::uint8_t label) const {
    return held_ && held_->label == label ? held_->voxels : segment::Growth::kAnyNumber;
}

void GrowthLimit::stop(const studio::DocumentFacts& facts) {
    stopped_ = Of{facts.segments.atWork, facts.growth.voxels};
    letGo();
}

bool GrowthLimit::hasStopped(const studio::DocumentFacts& facts) const {
    return stopped_ == Of{facts.segments.atWork, facts.growth.voxels};
}

} // namespace vs::desktop

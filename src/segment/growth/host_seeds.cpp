// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/host_seeds.h"

namespace vs::segment {

Frontier::SeedAnswer HostSeeds::answer(glm::ivec3 voxel, bool isAdmitted) {
    using enum Frontier::SeedAnswer;
    const std::size_t bit = seedMap_->bitOf(voxel);
    const bool isGrown = (map_.grown[bit / 32] >> bit % 32 & 1U) != 0;
    const bool isOwnVoxel = isGrown && isOwn(voxel);
    if (isGrown && !(isOwnVoxel && map_.generationAt(bit) > playhead_)) {
        return isOwnVoxel ? Present : Refused;
    }
    if (!isAdmitted || isBehindFence(voxel)) {
        return Refused;
    }
    return isForbidden(bit) ? AdmittedAgain : Admitted;
}

bool HostSeeds::isOwn(glm::ivec3 voxel) {
    if (!rules_->owner.hasOthers) {
        return true;
    }
    const std::uint32_t brick = seedMap_->bricks().brickOf(voxel);
    const auto known = labels_.try_emplace(brick, seedMap_->labels(), seedMap_->bricks().box(brick)).first;
    const auto label = std::to_integer<std::uint8_t>(*known->second.at(voxel));
    return label == 0 || label == rules_->owner.label;
}

bool HostSeeds::isBehindFence(glm::ivec3 voxel) {
    if (!rules_->constraints->hasFence()) {
        return false;
    }
    const std::uint32_t brick = seedMap_->bricks().brickOf(voxel);
    const auto known = fences_.try_emplace(brick, *rules_->constraints, seedMap_->bricks().box(brick)).first;
    return !known->second.letsIn(voxel);
}

bool HostSeeds::isForbidden(std::size_t bit) const {
    if (rules_->forbidden == nullptr) {
        return false;
    }
    const auto* words = reinterpret_cast<const std::uint32_t*>(rules_->forbidden->shared().data());
    return (words[bit / 32] >> bit % 32 & 1U) != 0;
}

} // namespace vs::segment

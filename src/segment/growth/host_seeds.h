// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/frontier.h"
#include "segment/growth/host_fence.h"

#include <map>

namespace vs::segment {

// What voxels can be seeds, asked on the host: shaders/test_seeds.comp, with equal answers. Internal to this
// folder.
class HostSeeds {
public:
    // All must outlive this; the map is shared.
    HostSeeds(const SeedMap& seedMap, const Frontier::Rules& rules, int playhead)
        : seedMap_(&seedMap), map_(seedMap.shared()), rules_(&rules), playhead_(std::uint32_t(playhead)) {}

    // `isAdmitted`: what the rules say of the voxel's value.
    Frontier::SeedAnswer answer(glm::ivec3 voxel, bool isAdmitted);

private:
    bool isOwn(glm::ivec3 voxel);
    bool isBehindFence(glm::ivec3 voxel);
    [[nodiscard]] bool isForbidden(std::size_t bit) const;

    const SeedMap* seedMap_;
    SeedMap::Shared map_;
    const Frontier::Rules* rules_;
    std::uint32_t playhead_;
    std::map<std::uint32_t, BrickTexels> labels_; // of the bricks that were asked about
    std::map<std::uint32_t, HostFence> fences_;
};

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/growth.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

// What a run's numbers of voxels say of playing it, wherever its voxels are kept. Internal to this module.
namespace vs::segment::playback {

inline std::uint64_t shownVoxels(const GrowthState& state) {
    return std::accumulate(state.voxels.begin(), state.voxels.begin() + state.playhead, std::uint64_t(0));
}

// The generation that seeds enter.
inline int enteringGeneration(const GrowthState& state) {
    return std::max({1, state.playhead, std::min(state.frozen, state.playhead) + 1});
}

// Where the playhead stands once up to `generations` of those kept are shown, or the first by which there are
// `mostVoxels`.
inline int revealed(const GrowthState& state, int generations, std::uint64_t mostVoxels) {
    const int last = state.playhead + std::clamp(state.extent - state.playhead, 0, std::max(generations, 0));
    int generation = state.playhead;
    for (auto count = shownVoxels(state); generation < last && count < mostVoxels; ++generation) {
        count += state.voxels[std::size_t(generation)];
    }
    return generation;
}

// The first generation shown by which there are `mostVoxels`; the playhead where there are fewer.
inline int firstWith(const GrowthState& state, std::uint64_t mostVoxels) {
    int last = state.playhead;
    for (auto count = shownVoxels(state);
         last > 1 && count - state.voxels[std::size_t(last - 1)] >= mostVoxels; --last) {
        count -= state.voxels[std::size_t(last - 1)];
    }
    return last;
}

} // namespace vs::segment::playback

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/growth.h"
#include "segment/growth/saved_brick.h"

#include <cstdint>
#include <map>
#include <vector>

namespace vs::segment {

// What a Growth holds, in memory of the host: for files. One that is made from it goes on as the other one
// would, generation by generation.
struct GrowthSnapshot {
    // A segment's run, without its voxels.
    struct Run {
        GrowthState state;
        std::vector<GenerationSpan> spans; // by brick; not of the segment at work, whose bricks have them
        std::vector<std::byte> forbidden;  // the plane, compressed; empty: nothing is forbidden
    };

    std::uint8_t label = 1; // of the segment at work
    Run atWork;
    std::map<std::uint8_t, Run> others;
    std::vector<SavedBrick> bricks; // all that hold anything
};

} // namespace vs::segment

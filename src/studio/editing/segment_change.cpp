// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/segment_change.h"

#include <cstdlib>

namespace vs::studio {

void rememberChange(Contents& contents, const Operation& operation, const SegmentList& before,
                    Region::Records& records) {
    Edit edit{shared(operation), {}, {}};
    if (!(contents.segments == before)) {
        edit.segmentsBefore = before;
        edit.segmentsAfter = contents.segments;
    }
    contents.history.makeRoom();
    edit.growth = std::move(records);
    contents.remember(std::move(edit));
}

void workUnlocked(Contents& contents, Region::Records& records) {
    const SegmentInfo& working = contents.segments.working();
    if (working.isLocked) {
        throw Error("the segment '{}' is locked; unlock it, or go to work on another", working.name);
    }
    contents.region.workOn(working.label, records);
}

Phrase describeChange(std::size_t voxelsBefore, std::size_t voxelsNow) {
    return voxelsNow > voxelsBefore ? say(VS_TEXT("library", "%1 voxels added"), voxelsNow - voxelsBefore)
                                    : say(VS_TEXT("library", "%1 voxels removed"), voxelsBefore - voxelsNow);
}

Outcome describeGrowth(const Contents& contents, int generations, std::size_t voxelsBefore) {
    const std::size_t now = contents.grownVoxels();
    const bool isOne = std::abs(generations) == 1;
    const char* grown = isOne ? VS_TEXT("library", "%1 generation; %2 voxels, %3 ml")
                              : VS_TEXT("library", "%1 generations; %2 voxels, %3 ml");
    const char* back = isOne ? VS_TEXT("library", "%1 generation back; %2 voxels, %3 ml")
                             : VS_TEXT("library", "%1 generations back; %2 voxels, %3 ml");
    return {{},
            0,
            now > voxelsBefore ? now - voxelsBefore : voxelsBefore - now,
            say(generations < 0 ? back : grown, std::abs(generations), now, contents.millilitres(now))};
}

} // namespace vs::studio

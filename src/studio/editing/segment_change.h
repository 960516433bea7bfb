// SPDX-License-Identifier: Apache-2.0
// How operations on segments are done, remembered and given up: for the editors of growth and of segments.
#pragma once

#include "base/error.h"
#include "studio/editing/contents.h"
#include "studio/editing/outcome.h"

#include <type_traits>
#include <utility>

namespace vs::studio {

// Does something to segments that may throw midway (a device without room, a person who gives up). When it
// throws, segments are as before.
template <typename Work>
auto changeOrNothing(Contents& contents, Region::Records& records, Work work) {
    SegmentList before = contents.segments;
    const bool existed = contents.region.exists();
    try {
        return work();
    } catch (...) {
        contents.region.undo(records);
        if (!existed) {
            contents.region.unmake();
        }
        contents.segments = std::move(before);
        throw;
    }
}

// Remembers a change of segments, which were `before`, as a step. The records are taken last: who catches
// what it throws has them still.
void rememberChange(Contents& contents, const Operation& operation, const SegmentList& before,
                    Region::Records& records);

// An editor does an operation on segments, perform(op, records), and it is remembered as one edit. Returns
// what perform() does.
template <typename Editor, typename Op>
auto changeSegments(Contents& contents, Editor& editor, const Op& op) {
    Region::Records records;
    const SegmentList before = contents.segments;
    return changeOrNothing(contents, records, [&] {
        if constexpr (std::is_void_v<decltype(editor.perform(op, records))>) {
            editor.perform(op, records);
            rememberChange(contents, op, before, records);
        } else {
            auto result = editor.perform(op, records);
            rememberChange(contents, op, before, records);
            return result;
        }
    });
}

// Goes to work on the segment at work. Throws Error when it is locked.
void workUnlocked(Contents& contents, Region::Records& records);

// "120 voxels added", "7 voxels removed".
Phrase describeChange(std::size_t voxelsBefore, std::size_t voxelsNow);

// What so many generations, forward or (negative) back, have made of the segment at work.
Outcome describeGrowth(const Contents& contents, int generations, std::size_t voxelsBefore);

} // namespace vs::studio

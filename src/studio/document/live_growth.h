// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "studio/editing/outcome.h"
#include "studio/state/region.h"

#include <optional>

namespace vs::studio {

struct Contents;
class GrowthEditor;
class OperationLog;

// Growth that is shown while it goes on: growing in portions of time, and scrubbing over generations. Each
// ends as one operation and one undo step. Nothing else may be done with the document meanwhile.
class LiveGrowth {
public:
    // All three must outlive it.
    LiveGrowth(Contents& contents, GrowthEditor& editor, OperationLog& log)
        : contents_(contents), editor_(editor), log_(log) {}

    // Takes the room that the first seeds need, so that they are answered at once. Nothing of the document
    // changes. Throws GlError when the device has none. giveBack() gives it back where there were none.
    void prepare();
    void giveBack();

    // Grows the segment at work: any number of portions of about `budgetMs`, of at most so many generations,
    // each ending with the generation in which the segment gets to have `mostVoxels`. growFor() returns false
    // when nothing grows any more. end() appends one Grow operation for all of them.
    // The sculpture fences it as `sculptureView` says: the view's when not set.
    void begin(std::optional<field::SculptureView> sculptureView = {});
    bool growFor(double budgetMs, int maxGenerations, std::uint64_t mostVoxels = segment::Growth::kAnyNumber);
    [[nodiscard]] bool isGrowing() const;
    Outcome end();

    // Shows a generation at once, unsmoothed. There must be seeds. endScrub() appends one ShowGeneration
    // operation for all that was shown.
    void scrub(int generation);
    [[nodiscard]] bool isScrubbing() const;
    Outcome endScrub();
    // Shows the generation of before, and leaves no trace.
    void dropScrub();

private:
    struct Run {
        Region::Records records;
        int playheadBefore = 0;
        std::size_t voxelsBefore = 0;
        field::SculptureView sculptureView = field::SculptureView::Cut;
        Timer timer;
    };

    Contents& contents_;
    GrowthEditor& editor_;
    OperationLog& log_;
    Run run_;
    int scrubbedFrom_ = 0; // the generation shown before
};

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/first_look.h"
#include "studio/editing/in_hand.h"
#include "studio/operations/operation.h"
#include "studio/operations/segment_list.h"
#include "studio/state/history.h"

#include <array>
#include <memory>
#include <vector>

namespace vs::studio {

struct Contents;

// How far the segment at work has grown.
struct GrowthStatus {
    int generation = 0;     // the one shown
    int extent = 0;         // the last one computed
    std::size_t voxels = 0; // grown at the generation shown
    double millilitres = 0;
    Range range;            // intensity range of the run
    std::vector<int> leaks; // the last generations before it leaked (segment::leaks)
    bool hasSeeds = false;
};

// What the segment at work may grow into; before its first seeds the rules that were set so far.
struct GrowthRules {
    Range range;
    std::optional<Range> difference;
    std::optional<Range> gradient;
    std::optional<Range> gradientDifference;
    int connectivity = 6;
    bool isLive = false;
};

// All that undo and redo go through, the oldest first; so many hold now.
struct Edits {
    std::vector<std::shared_ptr<const Operation>> operations;
    std::size_t done = 0;
    UndoStatistics statistics;
    std::uint64_t revision = 0; // History::revision()
};

// What is known of a document at one moment, as a value that stays as it is while the document goes on: what
// panels show, without asking a document that may be at work elsewhere.
struct DocumentFacts {
    std::uint64_t version = 0; // Document::version()
    std::size_t logged = 0;    // operations in the log
    InHand inHand = InHand::Nothing;
    volume::GridGeometry geometry; // where the scan's voxels lie, corrected where that was done
    glm::ivec3 finestDims{0};      // of the finest level that pictures show, where that is not this one
    View view;
    FirstLook firstLook; // that suits the scan: how the window shows it when it is opened
    Range sliceWindow;   // that suits the scan: what slices show where the view says nothing
    std::shared_ptr<const Edits> edits = std::make_shared<Edits>();
    // The measurements and what they come to; shared with earlier facts while that is the same.
    std::shared_ptr<const std::vector<Measured>> measured = std::make_shared<std::vector<Measured>>();
    Measurements measurements = std::make_shared<std::vector<Measure>>();
    bool hasMarks = false;
    bool hasFill = false;
    Materials materials = std::make_shared<const std::vector<Material>>(); // that can be filled in
    std::vector<PartInfo> parts; // that were pasted, in the order of the view's places
    SegmentList segments;
    std::array<std::size_t, 256> voxels{}; // shown of each segment, by its label
    double segmentVoxelMm3 = 0;            // of a voxel that segments are of
    std::uint64_t segmentsRevision = 0;    // counts changes of what is shown of segments
    GrowthStatus growth;
    GrowthRules rules;

    [[nodiscard]] bool isMarkOpen() const { return inHand == InHand::Mark; }
    // A stroke or a mark.
    [[nodiscard]] bool isStrokeOpen() const { return inHand == InHand::Stroke || isMarkOpen(); }
    [[nodiscard]] bool isGrowing() const { return inHand == InHand::Growth; }
    [[nodiscard]] bool isScrubbing() const { return inHand == InHand::Scrub; }
    [[nodiscard]] bool canUndo() const { return edits->done > 0; }
    [[nodiscard]] bool canRedo() const { return edits->done < edits->operations.size(); }
    // What undo would take back; null: nothing.
    [[nodiscard]] const Operation* lastEdit() const {
        return canUndo() ? edits->operations[edits->done - 1].get() : nullptr;
    }
};

// The facts of a document's contents, of which `before` are those of a moment ago: what has not changed since
// is shared with them. Needs no OpenGL context.
std::shared_ptr<const DocumentFacts> factsOf(const Contents& contents, std::size_t logged,
                                             const DocumentFacts& before);

} // namespace vs::studio

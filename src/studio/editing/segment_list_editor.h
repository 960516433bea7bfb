// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/outcome.h"

#include <array>

namespace vs::studio {

// Carries out the operations on the list of segments: which there are, how they look, which is at work, and
// those that a label map brings. run() and perform() are as in GrowthEditor.
class SegmentListEditor {
public:
    // The contents must outlive it.
    explicit SegmentListEditor(Contents& contents) : contents_(contents) {}

    Outcome run(UseSegment& op);
    Outcome run(RemoveSegment& op);
    Outcome run(ShowSegments& op);
    Outcome run(PullOut& op);
    Outcome run(PutBack& op);
    Outcome run(LoadLabels& op);

    void perform(const UseSegment& op, Region::Records& records);
    void perform(const RemoveSegment& op, Region::Records& records);
    void perform(const ShowSegments& op, Region::Records& records);
    void perform(const PullOut& op, Region::Records& records);
    void perform(const PutBack& op, Region::Records& records);
    // Returns how many voxels the segments got.
    std::size_t perform(const LoadLabels& op, Region::Records& records);

private:
    // The middles of the boxes around the segments' voxels, in the world (mm), by label; an empty one's is
    // the grid's.
    [[nodiscard]] std::array<glm::dvec3, 256> middles() const;

    Contents& contents_;
};

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/cut_editor.h"
#include "studio/editing/display.h"
#include "studio/editing/outcome.h"
#include "studio/strokes/cutter.h"

namespace vs::studio {

// Carries out the operations that give the segment at work another shape: edits of the whole (islands, holes,
// margins, set algebra) and brushes, flat on the picture or round in the volume. run() and perform() are as
// in GrowthEditor.
class SegmentShapeEditor {
public:
    // All four must outlive it.
    SegmentShapeEditor(Contents& contents, Display& display, Cutter& cutter, CutEditor& cuts)
        : contents_(contents), display_(display), cutter_(cutter), cuts_(cuts) {}

    Outcome run(EditSegment& op);
    Outcome run(BrushSegment& op);
    Outcome run(PaintSegment& op);
    Outcome run(SegmentFill& op);

    void perform(const EditSegment& op, Region::Records& records);
    void perform(const BrushSegment& op, Region::Records& records);
    void perform(const PaintSegment& op, Region::Records& records);
    void perform(const SegmentFill& op, Region::Records& records);

private:
    // The other segment that an edit takes, as take(its label) gives it; when it is united with the one at
    // work, it is empty afterwards.
    template <typename Take>
    auto takeOther(const EditSegment& op, Region::Records& records, Take take);
    // Where segments grow at the finest level: the edit of its voxels.
    void performFinest(const EditSegment& op, Region::Records& records);
    // The voxels of that level under a brush in the volume.
    segment::FineSet finestUnder(const PaintSegment& op);

    Contents& contents_;
    Display& display_;
    Cutter& cutter_;
    CutEditor& cuts_; // says what a brush's stroke would cut
};

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/display.h"
#include "studio/editing/outcome.h"
#include "studio/strokes/cutter.h"

namespace vs::studio {

// Carries out the operations on the growth of segments: seeds, growing and playing it, its rules, targeted
// shrink, and clearing it all. run() finds what the operation needs (canvas, seed voxels), writes it into the
// operation, does it, and remembers it as a step; it throws Error before anything has changed. perform() does
// it once all has been found: also again, by redo, with records of what undoes it.
class GrowthEditor {
public:
    // All three must outlive it.
    GrowthEditor(Contents& contents, Display& display, Cutter& cutter)
        : contents_(contents), display_(display), cutter_(cutter) {}

    // Takes the room that the first seeds need, and gives it back if there were none.
    void prepare();
    void giveBack();
    Outcome run(Seed& op);
    Outcome run(Grow& op);
    Outcome run(Rewind& op);
    Outcome run(ShowGeneration& op);
    Outcome run(SetGrowthRules& op);
    Outcome run(Absorb& op);
    Outcome run(ReSeed& op);

    segment::SeedCounts perform(const Seed& op, Region::Records& records);
    int perform(const Grow& op, Region::Records& records);
    int perform(const Rewind& op, Region::Records& records);
    void perform(const ShowGeneration& op, Region::Records& records);
    void perform(const SetGrowthRules& op, Region::Records& records);
    int perform(const Absorb& op, Region::Records& records);
    void perform(const ReSeed& op, Region::Records& records);

private:
    // The voxels, of the scene or of the finest level, seen under strokes on a canvas that growth by these
    // constraints may enter.
    std::vector<glm::ivec3> voxelsUnder(const std::vector<Sketch>& strokes, double widthPixels,
                                        const Canvas& canvas, const segment::Constraints& constraints,
                                        bool isOfFinest);

    Contents& contents_;
    Display& display_;
    Cutter& cutter_;
};

} // namespace vs::studio

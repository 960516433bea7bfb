// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_set.h"
#include "studio/operations/segment_list.h"
#include "studio/state/region.h"
#include "studio/strokes/cut_stroke.h"

#include <vector>

namespace vs::studio {

// Cuts a segment away, or all but it, with a margin around it (CutSegment), at the level that segments grow
// at: cut faces lie where its smooth surface does.
class SegmentStroke : public CutStroke {
public:
    // Throws Error when the segment is empty.
    SegmentStroke(Cutter& cutter, Region& region, const field::Field& field, const SegmentInfo& segment,
                  const CutSegment& operation);

    void replay() override;

private:
    void cutAtScene();
    void cutAtFinest();
    // Cuts the bricks that the set's surface does not reach, and says which of them must be cut voxel by
    // voxel.
    std::vector<bool> fillAround(const segment::FineSet& set);
    // What is cut of voxels that belong so much to the segment.
    [[nodiscard]] std::vector<float> energiesOf(std::vector<float> memberships) const;

    Region& region_;
    const field::Field& field_;
    std::uint8_t label_;
    bool keeps_;
    double marginMm_;
};

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture.h"
#include "segment/growth_undo.h"
#include "segment/seeds.h"
#include "studio/history.h"

#include <memory>

namespace vs::studio {

// The growing region of a document: made with the first seeds, since it needs memory in proportion to the
// volume. Each call returns or appends the records that undo it, in the order in which they were made.
class Region {
public:
    Region(const field::Field& field, const sculpt::Sculpture& sculpture)
        : field_(&field), sculpture_(&sculpture) {}

    using Records = std::vector<segment::GrowthUndo>;

    // What growth may enter: the range, and the visible side of the sculpture.
    [[nodiscard]] segment::Constraints constraints(const Range& range, field::SculptureView view,
                                                   segment::Connectivity connectivity) const;

    // The voxels that strokes found; none if nothing admissible was hit.
    std::vector<glm::ivec3> findSeeds(const field::SurfacePoints& points,
                                      const segment::Constraints& constraints);

    segment::SeedCounts seed(const std::vector<glm::ivec3>& voxels, const segment::Constraints& constraints,
                             Records& records);
    // Generations really added. Takes in first what has happened to the sculpture since the last call.
    int grow(int generations, field::SculptureView view, Records& records);
    int rewind(int generations, Records& records);
    void setRange(const Range& range, Records& records);
    void clear(Records& records);
    void undo(const Records& records);

    // Live growth: begin, any number of slices, end. The records of begin() undo all of it.
    void beginLive(field::SculptureView view, Records& records);
    int growFor(double budgetMs, int maxGenerations);
    static constexpr int kEndless = 1 << 30;
    void endLive(Records& records);

    [[nodiscard]] bool exists() const { return growth_ != nullptr; }
    [[nodiscard]] bool hasSeeds() const { return growth_ != nullptr && growth_->extent() > 0; }
    [[nodiscard]] const segment::Growth* growth() const { return growth_.get(); }

private:
    segment::Growth& madeGrowth();
    void refreshFence(field::SculptureView view, Records& records);

    const field::Field* field_;
    const sculpt::Sculpture* sculpture_;
    std::unique_ptr<segment::Growth> growth_;
    segment::SeedFinder finder_;
};

} // namespace vs::studio

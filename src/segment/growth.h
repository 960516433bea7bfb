// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/brick_table.h"
#include "segment/constraints.h"
#include "segment/frontier.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vs::segment {

class GrowthUndo;

// What became of the seeds of one call.
struct SeedCounts {
    int added = 0;
    int present = 0; // already grown (or offered twice)
    int refused = 0; // outside the grid or the range, or cut away
};

// Everything about a region but its voxels.
struct GrowthState {
    int playhead = 0;
    int extent = 0;
    bool isFinished = false;
    std::vector<std::uint64_t> voxels; // grown by generations 1, 2, ...; `extent` numbers
    Constraints constraints;

    bool operator==(const GrowthState&) const = default;
};

// A region grown breadth first from seeds, on the device. The seed map holds each voxel's generation: 0 not
// grown, seeds 1, their neighbours 2, and so on. `extent` is the largest generation computed, `playhead` the
// one shown (0: nothing).
//
// Generations after the playhead are kept while it moves. What changes the rules (other constraints, new
// seeds) erases them first, and then growth goes on from everything shown, so voxels refused earlier are
// tried again. The region is always what a plain queue gives that replays the same calls; every generation is
// exact and the same on each run.
//
// Calls that change anything take an optional record that undoes them (segment/growth_undo.h). One thread,
// one context.
class Growth {
public:
    // `field` must outlive this. Throws GlError when the device has no room for the seed map (4 bytes a
    // voxel, and 5/8 of a byte for the frontier).
    explicit Growth(const field::Field& field);

    // Nothing happens if they equal the present ones.
    void setConstraints(const Constraints& constraints, GrowthUndo* undo = nullptr);
    // Voxels to grow from, given the playhead's generation (at least 1) and shown at once. If none can be
    // added, nothing changes.
    SeedCounts addSeeds(std::span<const glm::ivec3> seeds, GrowthUndo* undo = nullptr);
    // Shows up to `generations` more: those kept first, then new ones. Returns how many there were; fewer
    // than asked for when nothing more grows.
    int advance(int generations, GrowthUndo* undo = nullptr);
    // As above, until about `budgetMs` milliseconds have passed (at least one generation).
    int advanceFor(double budgetMs, int generations, GrowthUndo* undo = nullptr);
    // Hides the newest generations shown. Returns how many.
    int stepBack(int generations, GrowthUndo* undo = nullptr);
    // Shows generations up to `generation`, clamped to [0, extent]; computes nothing.
    void setPlayhead(int generation, GrowthUndo* undo = nullptr);
    // Erases everything; the constraints stay.
    void reset(GrowthUndo* undo = nullptr);

    [[nodiscard]] int playhead() const { return state_.playhead; }
    [[nodiscard]] int extent() const { return state_.extent; }
    // Everything computed is shown, and under these rules nothing more grows.
    [[nodiscard]] bool isFinished() const { return state_.isFinished && state_.playhead == state_.extent; }
    // Voxels shown.
    [[nodiscard]] std::uint64_t voxelCount() const;
    [[nodiscard]] const Constraints& constraints() const { return state_.constraints; }
    [[nodiscard]] const GrowthState& state() const { return state_; }
    [[nodiscard]] const field::Field& field() const { return *field_; }
    // R32UI, one generation a voxel, hidden ones included: those up to the playhead are the region.
    [[nodiscard]] const gl::Texture& seedMap() const { return seedMap_; }
    // Box of whole bricks (clipped to the grid) around everything grown, hidden or not. After undoing it may
    // be larger.
    [[nodiscard]] Box3 touchedBox() const;

    // Counts changes of what is shown. Bricks of 32^3 voxels whose shown voxels may differ from those at an
    // earlier count.
    [[nodiscard]] std::uint64_t revision() const { return bricks_.revision(); }
    [[nodiscard]] std::vector<glm::ivec3> bricksChangedSince(std::uint64_t revision) const {
        return bricks_.changedSince(revision);
    }

    // Downloads the seed map, x fastest; with `upToPlayhead` hidden generations read 0.
    [[nodiscard]] std::vector<std::uint32_t> generations(bool upToPlayhead) const;
    // Downloads the region: 1 where shown, else 0.
    [[nodiscard]] std::vector<std::uint8_t> labels() const;

private:
    friend class GrowthUndo;

    [[nodiscard]] glm::ivec3 voxelAt(std::uint32_t index) const;
    void enterSeeds(std::span<const std::uint32_t> voxels);
    void movePlayhead(int generation);
    void truncate(int last, GrowthUndo* undo);
    void eraseAfter(int last);
    void storeGeneration(std::span<const std::uint32_t> voxels, int generation);
    int reveal(int generations);
    int compute(int generations);

    const field::Field* field_;
    GrowthState state_;
    gl::Texture seedMap_;
    BrickTable bricks_;
    Frontier frontier_;
    gl::Buffer list_;
    gl::Buffer answers_;
    gl::Program testSeeds_[2]; // without and with a fence, compiled when first needed
    gl::Program storeGeneration_;
    gl::Program eraseGenerations_;
};

} // namespace vs::segment

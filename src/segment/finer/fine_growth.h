// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_front.h"
#include "segment/finer/fine_set.h"
#include "segment/finer/tile_lists.h"
#include "segment/growth/growth.h"
#include "segment/growth/host_spread.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <unordered_set>
#include <vector>

namespace vs::segment {

struct FineUndo;

// Growth (segment/growth/growth.h) at the finest level of a scan that is worked on at a coarser one: the same
// segments, generation by generation, as Growth has on all of that level, with the same calls. It computes on
// the host and holds nothing but bricks of 32^3 voxels that something has grown in; values are read where the
// front comes to, so that what it takes follows what has grown and not the scan. Places are voxels of the
// finest level. Calls that change anything take an optional record; when they throw, nothing has changed, so
// that what was recorded is not to be undone.
class FineGrowth {
public:
    struct Seed {
        glm::ivec3 voxel{0};
        int generation = 0;
    };
    // All about one segment but its voxels. `state.seeds` is not used, and its constraints name a fence by
    // its version only.
    struct Run {
        GrowthState state;
        std::shared_ptr<const std::vector<Seed>> seeds = std::make_shared<const std::vector<Seed>>();
        std::shared_ptr<const ForbiddenBits> forbidden = std::make_shared<const ForbiddenBits>();
        FineFence fence = {}; // where the constraints have one
    };

    // `frontBytes`: what the front may take beside what has grown, before it lets go of what lies behind it.
    // `fenceNow` gives the fence as it is, which stays so; it is asked when constraints with one are set.
    FineGrowth(std::unique_ptr<FineValues> values, std::function<FineFence()> fenceNow,
               std::size_t frontBytes);

    void setConstraints(const Constraints& constraints, FineUndo* undo = nullptr);
    void setLive(bool isLive, FineUndo* undo = nullptr);
    SeedCounts addSeeds(std::span<const glm::ivec3> seeds, FineUndo* undo = nullptr);
    int advance(int generations, FineUndo* undo = nullptr);
    int advanceFor(double budgetMs, int generations, FineUndo* undo = nullptr,
                   std::uint64_t mostVoxels = Growth::kAnyNumber);
    int takeBack(int generations, FineUndo* undo = nullptr);
    void setPlayhead(int generation, FineUndo* undo = nullptr);
    int absorb(std::span<const glm::ivec3> voxels, int expansions, FineUndo* undo = nullptr);
    void reset(FineUndo* undo = nullptr);
    void activate(std::uint8_t label, FineUndo* undo = nullptr);

    // What becomes of some voxels of a brick: the segment loses those that are in `taken`, and gains those in
    // `given` that nobody has. What grows afterwards grows from new seeds only, as after Growth::replace().
    struct BrickEdit {
        std::uint32_t brick = 0;
        CellBits taken{};
        CellBits given{};
    };
    void edit(std::span<const BrickEdit> edits, FineUndo* undo = nullptr);
    // Makes the segment at work a set, and adds a set to it or takes it away; what others have stays theirs.
    void replace(const FineSet& set, FineUndo* undo = nullptr);
    void paint(const FineSet& set, bool isToAdd, FineUndo* undo = nullptr);

    void undo(const FineUndo& undo);

    // For each place, of the eight voxels around it that the rules let in by themselves the one nearest to it
    // in mm; places without such a voxel give none.
    [[nodiscard]] std::vector<glm::ivec3> nearestAdmitted(const std::vector<glm::dvec3>& places,
                                                          const Constraints& constraints) const;

    // The voxels that a segment is shown with; and those of a set that hold a value in a range.
    [[nodiscard]] FineSet voxels(std::uint8_t label) const;
    [[nodiscard]] FineSet inRange(const FineSet& set, const Range& range) const;

    [[nodiscard]] glm::ivec3 dims() const { return values_->field().geometry.dims; }
    [[nodiscard]] std::uint8_t label() const { return label_; }
    [[nodiscard]] const GrowthState& state() const { return run_.state; }
    // The generation in which seeds entered last, of those shown or kept; 0: none did.
    [[nodiscard]] int lastSeeded() const;
    [[nodiscard]] const std::map<std::uint8_t, Run>& others() const { return others_; }
    [[nodiscard]] bool isFinished() const {
        return run_.state.isFinished && run_.state.playhead == run_.state.extent;
    }
    [[nodiscard]] std::uint64_t voxelCount() const;
    using Bricks = std::vector<std::uint32_t>;
    // The bricks that hold generations of the segment at work after one.
    [[nodiscard]] Bricks holding(int after) const;
    [[nodiscard]] const FineMap& map() const { return map_; }
    [[nodiscard]] glm::ivec3 brickCounts() const { return divideUp(dims(), field::kBrick); }
    [[nodiscard]] glm::ivec3 placeOfBrick(std::uint32_t brick) const;
    [[nodiscard]] std::uint32_t brickOf(glm::ivec3 voxel) const;
    // A number that moves on whenever a voxel changes, and is no other growth's.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    // The bricks whose voxels have changed since they were last said to be shown.
    [[nodiscard]] std::vector<std::uint32_t> changed() const;
    void noteShown() { changed_.clear(); }

    // The segment that each voxel of a box is shown in, x fastest; 0: none. And the generations of the
    // segment at work, hidden ones too.
    [[nodiscard]] std::vector<std::uint8_t> labelMap(const Box3& box) const;
    [[nodiscard]] std::vector<std::uint32_t> generations(const Box3& box) const;
    // Label maps of boxes of all as it is now: it stays so, and threads may ask at once.
    [[nodiscard]] std::function<std::vector<std::uint8_t>(const Box3&)> labelReader() const;
    // Whether boxes of it are known to have no label, likewise.
    [[nodiscard]] std::function<bool(const Box3&)> emptyBoxes() const;
    // The bricks' box around what is shown of a segment.
    [[nodiscard]] Box3 boxOf(std::uint8_t label) const;
    // What it takes on the host.
    [[nodiscard]] std::size_t memoryBytes() const;
    // Where the level's voxels lie, which may have been corrected.
    void follow(const volume::GridGeometry& finest);

private:
    class Recording;

    [[nodiscard]] FineRules rules() const;
    void replaceCells(std::uint32_t brick, const OpenCells& open);
    void dropCells(std::uint32_t brick);
    void putBack(const std::map<std::uint32_t, FineCellsPtr>& bricks);
    void takeBack(const FineUndo& noted);
    // Gives listed voxels the generation that enters now.
    void enterSeeds(const std::vector<glm::ivec3>& voxels);
    void reinstateSeeds();
    [[nodiscard]] Frontier::SeedAnswer answer(glm::ivec3 voxel, const FineRules& rules) const;
    void retract();
    void truncate(int last);
    void eraseAfter(int last);
    int reveal(int generations, std::uint64_t mostVoxels);
    int cutBack(std::uint64_t mostVoxels);
    int compute(int generations);
    std::vector<std::uint64_t> expand(int expansions);
    void collect();
    void commit(std::uint32_t from);
    void freeze();
    // Spreads from seeds through `region`; the voxels that were reached, by brick.
    std::unordered_map<std::uint32_t, CellBits> flood(FineBricks& region,
                                                      const std::vector<glm::ivec3>& seeds,
                                                      Connectivity connectivity, int expansions,
                                                      int& found) const;
    // Takes voxels of generations after `last` away that `isTaken` says, and counts them off.
    void erase(const Bricks& among, int last, const std::function<bool(std::uint32_t, std::size_t)>& isTaken);

    std::unique_ptr<FineValues> values_;
    std::function<FineFence()> fenceNow_;
    std::size_t frontBytes_;
    FineMap map_;
    std::uint8_t label_ = 1;
    Run run_;
    std::map<std::uint8_t, Run> others_;
    TileLists lists_; // of what joins until it is committed
    FineBricksToGrowInto bricks_;
    HostSpread spread_;
    std::vector<glm::ivec3> added_; // seeds that the front has not taken up yet
    bool isValid_ = false;          // the front
    void noteChanged(std::uint32_t brick);
    std::unordered_set<std::uint32_t> changed_;
    std::uint64_t revision_ = 0;
    FineUndo* recording_ = nullptr; // of the call under way
};

// Undoes one call that changed a FineGrowth, as GrowthUndo does: redo is calling again. What advancing added
// is not kept, since erasing it needs only its number.
struct FineUndo {
    std::uint8_t label = 0; // before the call; 0: nothing was called
    FineGrowth::Run run;    // of that segment
    std::map<std::uint32_t, FineCellsPtr> bricks;

    [[nodiscard]] std::size_t bytes() const;
};

} // namespace vs::segment

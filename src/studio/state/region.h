// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture/sculpture.h"
#include "segment/edits/voxel_set.h"
#include "segment/growth/growth_snapshot.h"
#include "segment/growth/seeds.h"
#include "studio/operations/operation.h"
#include "studio/state/finest_region.h"
#include "studio/state/history.h"

#include <memory>
#include <optional>

namespace vs::studio {

// 6 or 26 neighbours.
segment::Connectivity connectivityOf(int neighbours);

// The segments of a document: made with the first seeds, since they need memory in proportion to the volume.
// Everything happens to the segment at work. Each call returns or appends the records that undo it, in the
// order in which they were made.
class Region {
public:
    Region(const field::Field& field, const sculpt::Sculpture& sculpture)
        : field_(&field), sculpture_(&sculpture) {}

    using Records = std::vector<RegionUndo>;

    // Segments grow at a finer level than the scene's from now on; there must be none yet. The sculpture has
    // a finer one. What is said of voxels is then of the scene's, which show what has grown there
    // (segment::SceneView), but for seeds that are given as finest ones; generations, and numbers of voxels,
    // are the finest level's.
    void refine(const FinestLevel& level) { finestLevel_ = level; }
    [[nodiscard]] bool isFiner() const { return finestLevel_.has_value(); }
    // Its voxels in the scene's voxel space; where it is finer alone.
    [[nodiscard]] const field::BrickGrid& finestGrid() const { return finestLevel_->grid; }
    // What has grown there; null: nothing yet, or segments are the scene's.
    [[nodiscard]] const segment::FineGrowth* finest() const {
        return growth_ && finest_ ? &finest_->growth() : nullptr;
    }
    // Where the voxels lie that segments are of.
    [[nodiscard]] volume::GridGeometry geometry() const;

    // What growth may enter: the range, and the visible side of the sculpture.
    [[nodiscard]] segment::Constraints constraints(const Range& range, field::SculptureView view,
                                                   segment::Connectivity connectivity) const;

    // Takes the room that segments need; as far as anybody can see there are none yet. And gives back what
    // was not used.
    void prepare();
    void giveBack() { prepared_.reset(); }

    // The voxels that strokes found; none if nothing admissible was hit.
    std::vector<glm::ivec3> findSeeds(const field::SurfacePoints& points,
                                      const segment::Constraints& constraints);

    // The voxels of the finest level that strokes found, where segments grow at that one; and all of it that
    // lie in some of the scene's.
    std::vector<glm::ivec3> findFinestSeeds(const field::SurfacePoints& points,
                                            const segment::Constraints& constraints);
    [[nodiscard]] std::vector<glm::ivec3> finestIn(const std::vector<glm::ivec3>& sceneVoxels);

    // A growth of its own at the finest level, where segments grow at that one, for what is connected there:
    // segments know nothing of it.
    [[nodiscard]] FinestRegion apart() const;

    // `finest`, where segments grow at the finest level and any are given, otherwise `voxels`.
    segment::SeedCounts seed(const std::vector<glm::ivec3>& voxels, const std::vector<glm::ivec3>& finest,
                             const segment::Constraints& constraints, Records& records);
    // Generations really added. Takes in first what has happened to the sculpture since the last call.
    int grow(int generations, field::SculptureView view, Records& records);
    int rewind(int generations, Records& records);
    void showGeneration(int generation, Records& records);
    // Shows the region up to a generation without a record; for scrubbing, which ends where it began.
    void scrub(int generation);
    void setRules(const SetGrowthRules& rules, Records& records);
    // Targeted shrink; returns how many expansions found something.
    int absorb(const std::vector<glm::ivec3>& voxels, const std::vector<glm::ivec3>& finest, int expansions,
               Records& records);
    // Voxels shown of any segment, and making the segment at work a set of them (as segment::Growth does).
    segment::VoxelSet voxels(std::uint8_t label, Records& records);
    // The voxels alone; everything is as before.
    segment::VoxelSet voxelsOf(std::uint8_t label);
    void replace(const segment::VoxelSet& set, Records& records);
    // Adds a set to the segment at work, or takes it away.
    void paint(const segment::VoxelSet& set, bool isToAdd, Records& records);
    // Where segments grow at the finest level: the voxels of that which a segment is shown with, those of a
    // set that hold a value in a range, and what replace() and paint() do.
    [[nodiscard]] segment::FineSet finestVoxels(std::uint8_t label);
    [[nodiscard]] segment::FineSet finestInRange(const segment::FineSet& set, const Range& range);
    void replace(const segment::FineSet& set, Records& records);
    void paint(const segment::FineSet& set, bool isToAdd, Records& records);
    // Goes to work on a segment.
    void workOn(std::uint8_t label, Records& records);
    // Erases the segment at work.
    void clear(Records& records);
    // It follows no rules any more, as one that has just been made.
    void forgetRules(Records& records);
    // Undoes what was recorded, also of a call that threw. When memory is refused, it tries once more, and
    // goes on where it stopped.
    void undo(const Records& records);
    // There are no segments any more: for a call that threw and made them.
    void unmake() {
        growth_.reset();
        finest_.reset();
    }

    // Live growth: begin, any number of slices, end. The records of begin() undo all of it.
    void beginLive(field::SculptureView view, Records& records);
    int growFor(double budgetMs, int maxGenerations, std::uint64_t mostVoxels);
    static constexpr int kEndless = 1 << 30;
    void endLive(Records& records);

    // For files: there must be no segments yet. Throws Error when they do not fit the volume.
    void restore(const segment::GrowthSnapshot& all) { madeGrowth().restore(all); }

    [[nodiscard]] bool exists() const { return growth_ != nullptr; }
    [[nodiscard]] bool hasSeeds() const { return growth_ != nullptr && growth_->extent() > 0; }
    // The segment at work has no voxels and follows no rules, as one that has just been made.
    [[nodiscard]] bool isUntouched() const;
    // Rules of the segment at work; before the first seeds, those that were set so far.
    [[nodiscard]] const segment::Constraints& rules() const;
    [[nodiscard]] const segment::Growth* growth() const { return growth_.get(); }

    // Voxels shown of a segment, by its label, of the level that it grows at.
    [[nodiscard]] std::size_t voxelCount(std::uint8_t label) const;
    // Counts changes of what is shown of segments.
    [[nodiscard]] std::uint64_t revision() const;
    // For each voxel, x fastest: the generation in which the segment at work took it, as far as is shown, 0
    // where it has not grown; 1 where it is in the segment at work, else 0; its segment's label, 0 in none.
    [[nodiscard]] std::vector<std::uint32_t> generations() const;
    [[nodiscard]] std::vector<std::uint8_t> labels() const;
    [[nodiscard]] std::vector<std::uint8_t> labelMap() const;

private:
    segment::Growth& madeGrowth();
    FinestRegion& madeFinest();
    // Has the growth that segments are of changed: change(it, the record that undoes that).
    template <typename Change>
    void change(Records& records, const Change& change);
    template <typename Change>
    void change(const Change& change);
    void refreshFence(field::SculptureView view, Records& records);

    const field::Field* field_;
    const sculpt::Sculpture* sculpture_;
    std::unique_ptr<segment::Growth> growth_;
    std::unique_ptr<segment::Growth> prepared_; // will be that, for the field
    std::uint64_t preparedFor_ = 0;             // with this serial
    std::optional<FinestLevel> finestLevel_;
    std::unique_ptr<FinestRegion> finest_; // of which growth_ is what the scene shows
    segment::SeedFinder finder_;
};

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/constraints.h"
#include "segment/growth/frontier.h"
#include "segment/growth/region_passes.h"
#include "segment/growth/seed_map.h"

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vs::segment {

class GrowthUndo;
struct GrowthSnapshot;

// What became of the seeds of one call.
struct SeedCounts {
    int added = 0;
    int present = 0; // already grown (or offered twice)
    int refused = 0; // outside the grid or the range, cut away, or another segment's
};

// A voxel that growth was asked to begin from, whether it was let in or not, and the generation it entered
// (or would have).
struct Seed {
    std::uint32_t voxel = 0;
    int generation = 0;

    bool operator==(const Seed&) const = default;
};

// Everything about one segment's run but its voxels.
struct GrowthState {
    static constexpr int kNever = std::numeric_limits<int>::max();

    int playhead = 0;
    int extent = 0;
    bool isFinished = false;
    std::vector<std::uint64_t> voxels; // grown by generations 1, 2, ...; `extent` numbers
    Constraints constraints;
    bool isLive = false;
    // From this extent on, everything grown can be reached under the present rules: each later generation by
    // the one before it, but those up to this one perhaps by one another in another order. kNever: nobody
    // knows. In live mode only, which it spares looking through everything: a segment is the same whether or
    // not this is known.
    int consistentFrom = 0;
    // Generations up to this one are what an edit or a label map gave: they do not grow, nor are they
    // retracted.
    int frozen = 0;
    std::shared_ptr<const std::vector<Seed>> seeds = std::make_shared<const std::vector<Seed>>();

    bool operator==(const GrowthState&) const = default;
};

// Segments grown breadth first from seeds, on the device, one of them at work at a time; no voxel is in two.
// Each voxel of a segment has a generation: seeds 1, their neighbours 2, and so on. `extent` is the largest
// generation computed, `playhead` the one shown (0: nothing).
//
// Generations after the playhead are kept while it moves. What changes the rules (other constraints, new
// seeds) erases them first, and then growth goes on from everything shown: voxels refused earlier, seeds
// among them, are tried again. In live mode new rules also take away what could not be reached from the seeds
// under them; a voxel that stays keeps its generation. The region is always what a plain queue gives that
// replays the same calls; every generation is exact and the same on each run.
//
// Calls that change anything take an optional record that undoes them (segment/growth/growth_undo.h), also
// when they throw midway. One thread, one context.
class Growth {
public:
    // `field` must outlive this. Throws GlError when the device has no room: 2 bytes and 5 bits a voxel for
    // the run, 1 byte for the segments, of the grid filled up to bricks of 32^3 voxels. What it computes is
    // the same to the byte wherever it is computed.
    explicit Growth(const field::Field& field, GrowthEngine engine = quickerEngine());

    // Changes the rules. Nothing happens if they equal the present ones.
    void setConstraints(const Constraints& constraints, GrowthUndo* undo = nullptr);
    // Live mode: later changes of the constraints take away what is no longer reachable.
    void setLive(bool isLive, GrowthUndo* undo = nullptr);
    // Voxels to grow from, given the playhead's generation (at least 1) and shown at once. If none can be
    // added, nothing changes.
    SeedCounts addSeeds(std::span<const glm::ivec3> seeds, GrowthUndo* undo = nullptr);
    // Shows up to `generations` more: those kept first, then new ones. Returns how many there were; fewer
    // than asked for when nothing more grows.
    int advance(int generations, GrowthUndo* undo = nullptr);
    // Shows more generations, as advance() does, until about `budgetMs` milliseconds have passed (at least
    // one generation), or up to the first one by which the segment has `mostVoxels`.
    int advanceFor(double budgetMs, int generations, GrowthUndo* undo = nullptr,
                   std::uint64_t mostVoxels = kAnyNumber);
    static constexpr std::uint64_t kAnyNumber = std::numeric_limits<std::uint64_t>::max();
    // Hides the newest generations shown. Returns how many.
    int takeBack(int generations, GrowthUndo* undo = nullptr);
    // Shows generations up to `generation`, clamped to [0, extent]; computes nothing.
    void setPlayhead(int generation, GrowthUndo* undo = nullptr);

    // Targeted shrink: takes away what is shown of the segment from these voxels outward, by as many
    // expansions. What was taken away stays forbidden to it until it is seeded again. Returns how many
    // expansions found something.
    int absorb(std::span<const glm::ivec3> voxels, int expansions, GrowthUndo* undo = nullptr);
    // Makes the segment what an edit has made of it: one byte a voxel of a box, nothing outside. Voxels of
    // other segments stay theirs. New voxels get the playhead's generation; from then on only new seeds grow.
    void replace(const Box3& box, std::span<const std::uint8_t> inside, GrowthUndo* undo = nullptr);
    // Adds voxels to the segment or takes them away, with the consequences that replace() has: a brush. The
    // cost follows the bricks of the box.
    void paint(const Box3& box, std::span<const std::uint8_t> inside, bool isToAdd,
               GrowthUndo* undo = nullptr);
    // Voxels that no segment may grow into (one byte a voxel of the grid, 0 = forbidden), until reset.
    void confine(std::span<const std::uint8_t> inside);

    // Erases the segment at work; the constraints stay.
    void reset(GrowthUndo* undo = nullptr);

    // Goes to work on another segment (1 to 255); the first is 1. What the former one hides is erased.
    void activate(std::uint8_t label, GrowthUndo* undo = nullptr);
    [[nodiscard]] std::uint8_t activeLabel() const { return owner_.label; }

    // All that it holds (segment/growth/growth_snapshot.h); and a growth that has just been made becomes what
    // such a snapshot says. Throws Error when that does not fit the volume.
    [[nodiscard]] GrowthSnapshot snapshot() const;
    void restore(const GrowthSnapshot& all);

    // Shows from now on what has grown elsewhere, at a finer level of the same scan
    // (segment/finer/scene_view.h): which segment is at work there and how far each has grown, in that
    // level's generations and voxels, and the bricks that have changed since it was last called. Nothing else
    // may change it then.
    void mirror(std::uint8_t label, const GrowthState& atWork,
                const std::map<std::uint8_t, GrowthState>& others, std::span<const std::uint32_t> bricks,
                const MirrorOf& told);

    [[nodiscard]] int playhead() const { return state_.playhead; }
    [[nodiscard]] int extent() const { return state_.extent; }
    // Whether everything computed is shown, and nothing more grows under these rules.
    [[nodiscard]] bool isFinished() const { return state_.isFinished && state_.playhead == state_.extent; }
    // Voxels shown, of the segment at work and of any.
    [[nodiscard]] std::uint64_t voxelCount() const;
    [[nodiscard]] std::uint64_t voxelCount(std::uint8_t label) const;
    [[nodiscard]] const Constraints& constraints() const { return state_.constraints; }
    [[nodiscard]] const GrowthState& state() const { return state_; }
    // How far any segment has grown; a fresh state if it has not been at work.
    [[nodiscard]] const GrowthState& state(std::uint8_t label) const;
    [[nodiscard]] bool hasOthers() const { return owner_.hasOthers; }
    [[nodiscard]] const Owner& owner() const { return owner_; }
    [[nodiscard]] const field::Field& field() const { return *field_; }
    // The segments as the device has them; labels are up to date after syncLabels().
    [[nodiscard]] const SeedMap& seedMap() const { return seedMap_; }
    void syncLabels() const;
    // Box of whole bricks (clipped to the grid) around everything grown in the segment at work, hidden or
    // not. After undoing it may be larger.
    [[nodiscard]] Box3 touchedBox() const;

    // What growth takes at the moment, volume and sculpture aside: on the device, and on the host instead
    // where it grows there.
    [[nodiscard]] std::size_t deviceBytes() const {
        return seedMap_.deviceBytes() + frontier_->bytes() + forbidden_.size();
    }

    // Counts changes of what is shown.
    [[nodiscard]] std::uint64_t revision() const { return seedMap_.bricks().revision(); }

    // Writes what is shown in some bricks into a plane of bits (laid out as in shaders/words.glsl): the
    // voxels of segments whose number in `kinds` (one for each label) is `wanted`, of the segment at work up
    // to the playhead. `reach` takes, for each brick listed and each of its eight tiles of 16^3 voxels (x
    // fastest), which of the 27 tiles around it (bit (dx + 1) + 3 (dy + 1) + 9 (dz + 1)) lie within 3 voxels
    // of voxels that have changed in the plane; it must be zero before. With `owners`, as large as the plane
    // and zero at first, voxels that have gone from one segment to another have changed too.
    void show(const gl::Buffer& plane, const gl::Buffer& reach, const std::vector<std::uint32_t>& bricks,
              std::span<const std::uint32_t> kinds, std::uint32_t wanted,
              const gl::Buffer* owners = nullptr) const;

    // Downloads the generations of the segment at work, x fastest; with `upToPlayhead` hidden ones read 0.
    [[nodiscard]] std::vector<std::uint32_t> generations(bool upToPlayhead) const;
    // Downloads what is shown of the segment at work in a box: 1 inside, else 0.
    [[nodiscard]] std::vector<std::uint8_t> labels(const Box3& box) const;
    [[nodiscard]] std::vector<std::uint8_t> labels() const;
    // Downloads the segment that each voxel is shown in; 0: none.
    [[nodiscard]] std::vector<std::uint8_t> labelMap() const;

private:
    friend class GrowthUndo;

    // What is kept of a segment that is not at work.
    struct Run {
        GrowthState state;
        std::vector<GenerationSpan> spans;
        std::vector<std::uint32_t> forbidden; // the plane; empty: nothing is
    };

    [[nodiscard]] Frontier::Rules rules() const;
    std::vector<std::uint32_t> voxelsInGrid(std::span<const glm::ivec3> voxels) const;
    std::vector<Frontier::SeedAnswer> testSeeds(const std::vector<std::uint32_t>& voxels);
    void enterSeeds(std::span<const std::uint32_t> voxels, GrowthUndo* undo);
    int enteringGeneration() const;
    void reinstateSeeds(GrowthUndo* undo);
    void retract(GrowthUndo* undo);
    void movePlayhead(int generation);
    void truncate(int last, GrowthUndo* undo);
    void eraseAfter(int last);
    void eraseByPlane(const gl::Buffer& plane, bool isInPlane, int last,
                      const std::vector<std::uint32_t>& among, GrowthUndo* undo);
    void addByPlane(const gl::Buffer& plane, const std::vector<std::uint32_t>& among, GrowthUndo* undo);
    void freeze();
    int reveal(int generations, std::uint64_t mostVoxels);
    int cutBack(std::uint64_t mostVoxels);
    int compute(int generations);
    std::vector<std::uint64_t> expand(int expansions);
    void exchangeRun(std::uint8_t label);
    [[nodiscard]] bool hasGrownOthers() const;

    const field::Field* field_;
    GrowthState state_;
    mutable SeedMap seedMap_; // labels are written when asked for
    mutable std::uint64_t labelledRevision_ = 0;
    std::unique_ptr<Frontier> frontier_;
    RegionPasses passes_;
    Owner owner_;
    std::map<std::uint8_t, Run> others_;
    gl::Buffer forbidden_; // a plane, made when first needed
    mutable gl::Buffer kinds_;
    mutable gl::ProgramVariants show_{"segment/shaders/show_rows.comp"};
};

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_growth.h"

#include "base/progress.h"
#include "base/timer.h"
#include "segment/finer/fine_recording.h"
#include "segment/growth/playback.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vs::segment {

namespace {

constexpr int kNever = GrowthState::kNever;
// The most expansions at once.
constexpr int kMostExpansions = 1 << 14;

// The label that each voxel of a box is shown with.
std::vector<std::uint8_t> labelsIn(const FineMap& map, glm::ivec3 dims, std::uint8_t atWork, int playhead,
                                   const Box3& box) {
    std::vector<std::uint8_t> labels(box.volume());
    const glm::ivec3 size = box.size();
    const field::BrickGrid grid{dims, field::kBrick};
    forEachVoxel(
        Box3{box.lo / field::kBrick, divideUp(box.hi, field::kBrick)}, [&](glm::ivec3 at, std::size_t) {
            const auto known = map.find(std::uint32_t(grid.placeOf(at)));
            if (known == map.end()) {
                return;
            }
            const FineCells& cells = *known->second;
            const glm::ivec3 lo = at * field::kBrick;
            forEachVoxel(intersect(box, {lo, lo + field::kBrick}), [&](glm::ivec3 voxel, std::size_t) {
                const std::size_t cell = cellOf(voxel - lo);
                const std::uint32_t generation = cells.generation(cell);
                if (generation == 0) {
                    return;
                }
                const std::uint8_t label = cells.label(cell);
                if (label != atWork || int(generation) <= playhead) {
                    const glm::ivec3 v = voxel - box.lo;
                    labels[(std::size_t(v.z) * std::size_t(size.y) + std::size_t(v.y)) * std::size_t(size.x) +
                           std::size_t(v.x)] = label;
                }
            });
        });
    return labels;
}

} // namespace

FineGrowth::FineGrowth(std::unique_ptr<FineValues> values, std::function<FineFence()> fenceNow,
                       std::size_t frontBytes)
    : values_(std::move(values)), fenceNow_(std::move(fenceNow)), frontBytes_(frontBytes),
      bricks_(values_->field().geometry.dims, frontBytes), spread_(bricks_, values_->field().geometry.dims) {}

FineRules FineGrowth::rules() const {
    return {values_.get(),        &map_, &run_.state.constraints, run_.fence ? &run_.fence : nullptr,
            run_.forbidden.get(), label_};
}

glm::ivec3 FineGrowth::placeOfBrick(std::uint32_t brick) const {
    const glm::uvec3 n(brickCounts());
    return {int(brick % n.x), int(brick / n.x % n.y), int(brick / (n.x * n.y))};
}

std::uint32_t FineGrowth::brickOf(glm::ivec3 voxel) const {
    const glm::ivec3 n = brickCounts();
    const glm::ivec3 place = voxel / field::kBrick;
    return std::uint32_t((place.z * n.y + place.y) * n.x + place.x);
}

// --- rules

void FineGrowth::setConstraints(const Constraints& constraints, FineUndo* undo) {
    const Recording recording(undo, *this);
    if (constraints == run_.state.constraints) {
        return;
    }
    truncate(run_.state.playhead);
    const bool isWider = includes(constraints, run_.state.constraints);
    run_.state.constraints = constraints;
    run_.fence = constraints.hasFence() ? fenceNow_() : FineFence();
    isValid_ = false;
    if (!isWider || run_.state.consistentFrom > run_.state.extent) {
        if (run_.state.isLive) {
            retract();
        }
        run_.state.consistentFrom = run_.state.extent == 0 ? 0
                                    : run_.state.isLive    ? run_.state.extent
                                                           : kNever;
    }
    run_.state.isFinished = false;
    reinstateSeeds();
}

void FineGrowth::setLive(bool isLive, FineUndo* undo) {
    const Recording recording(undo, *this);
    run_.state.isLive = isLive;
}

// --- playback

int FineGrowth::advance(int generations, FineUndo* undo) {
    return advanceFor(std::numeric_limits<double>::infinity(), generations, undo);
}

int FineGrowth::advanceFor(double budgetMs, int generations, FineUndo* undo, std::uint64_t mostVoxels) {
    const Recording recording(undo, *this);
    const Timer timer;
    int shown = reveal(generations, mostVoxels);
    // Batches double while they fit into what is left of the time.
    int batch = budgetMs < std::numeric_limits<double>::infinity() ? 1 : kMostExpansions;
    while (shown < generations && !isFinished() && (shown == 0 || timer.milliseconds() < budgetMs) &&
           (mostVoxels == Growth::kAnyNumber || voxelCount() < mostVoxels)) {
        reportProgress();
        const double began = timer.milliseconds();
        shown += compute(std::min(batch, generations - shown));
        shown -= mostVoxels == Growth::kAnyNumber ? 0 : cutBack(mostVoxels);
        const double ended = timer.milliseconds();
        batch = budgetMs - ended > 2 * (ended - began) ? std::min(2 * batch, kMostExpansions)
                                                       : std::max(batch / 2, 1);
    }
    return shown;
}

int FineGrowth::reveal(int generations, std::uint64_t mostVoxels) {
    const int before = run_.state.playhead;
    run_.state.playhead = playback::revealed(run_.state, generations, mostVoxels);
    return run_.state.playhead - before;
}

// Takes back what has just been computed after the first generation by which there are so many voxels.
int FineGrowth::cutBack(std::uint64_t mostVoxels) {
    GrowthState& state = run_.state;
    const int last = playback::firstWith(state, mostVoxels);
    const int surplus = state.playhead - last;
    if (surplus > 0) {
        state.playhead = last;
        truncate(last);
    }
    return surplus;
}

int FineGrowth::compute(int generations) {
    GrowthState& state = run_.state;
    const int expansions = std::min(generations, SeedMap::kLongest - state.extent);
    if (expansions <= 0) {
        state.isFinished = true;
        return 0;
    }
    const auto grown = expand(expansions);
    const auto tried = int(grown.size());
    const auto added = int(std::find(grown.begin(), grown.end(), 0U) - grown.begin());
    state.voxels.insert(state.voxels.end(), grown.begin(), grown.begin() + added);
    state.extent += added;
    state.isFinished = added < tried;
    state.playhead = state.extent;
    return added;
}

int FineGrowth::takeBack(int generations, FineUndo* undo) {
    const int before = run_.state.playhead;
    setPlayhead(before - std::clamp(generations, 0, before), undo);
    return before - run_.state.playhead;
}

void FineGrowth::setPlayhead(int generation, FineUndo* undo) {
    const Recording recording(undo, *this);
    run_.state.playhead = std::clamp(generation, 0, run_.state.extent);
}

// --- asking

int FineGrowth::lastSeeded() const {
    int last = 0;
    for (const Seed& seed : *run_.seeds) {
        last = std::max(last, seed.generation);
    }
    return last;
}

void FineGrowth::follow(const volume::GridGeometry& finest) {
    if (!(finest == values_->field().geometry)) {
        values_->follow(finest);
        isValid_ = false; // gradients are others
    }
}

std::uint64_t FineGrowth::voxelCount() const { return playback::shownVoxels(run_.state); }

std::vector<std::uint32_t> FineGrowth::changed() const {
    std::vector<std::uint32_t> bricks(changed_.begin(), changed_.end());
    std::sort(bricks.begin(), bricks.end());
    return bricks;
}

FineGrowth::Bricks FineGrowth::holding(int after) const {
    Bricks bricks;
    for (const auto& [brick, cells] : map_) {
        if (cells->holds(label_, after)) {
            bricks.push_back(brick);
        }
    }
    std::sort(bricks.begin(), bricks.end());
    return bricks;
}

Box3 FineGrowth::boxOf(std::uint8_t label) const {
    Box3 box;
    for (const auto& [brick, cells] : map_) {
        if (cells->holds(label, 0)) {
            const glm::ivec3 lo = placeOfBrick(brick) * field::kBrick;
            box = unite(box, {lo, glm::min(lo + field::kBrick, dims())});
        }
    }
    return box;
}

std::function<std::vector<std::uint8_t>(const Box3&)> FineGrowth::labelReader() const {
    return [map = map_, dims = dims(), atWork = label_, playhead = run_.state.playhead](const Box3& box) {
        return labelsIn(map, dims, atWork, playhead, box);
    };
}

std::function<bool(const Box3&)> FineGrowth::emptyBoxes() const {
    return [map = map_, dims = dims()](const Box3& box) {
        const field::BrickGrid grid{dims, field::kBrick};
        bool isEmpty = true;
        forEachVoxel(Box3{box.lo / field::kBrick, divideUp(box.hi, field::kBrick)},
                     [&](glm::ivec3 at, std::size_t) {
                         isEmpty = isEmpty && !map.contains(std::uint32_t(grid.placeOf(at)));
                     });
        return isEmpty;
    };
}

std::vector<std::uint8_t> FineGrowth::labelMap(const Box3& box) const {
    return labelsIn(map_, dims(), label_, run_.state.playhead, box);
}

std::vector<std::uint32_t> FineGrowth::generations(const Box3& box) const {
    std::vector<std::uint32_t> values;
    values.reserve(box.volume());
    forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t) {
        const auto known = map_.find(brickOf(voxel));
        const std::size_t cell = cellOf(voxel & (field::kBrick - 1));
        const bool isOwn = known != map_.end() && known->second->generation(cell) != 0 &&
                           known->second->label(cell) == label_;
        values.push_back(isOwn ? known->second->generation(cell) : 0);
    });
    return values;
}

std::size_t FineGrowth::memoryBytes() const {
    std::size_t bytes = bricks_.memoryBytes() + lists_.bytes();
    for (const auto& [brick, cells] : map_) {
        bytes += cells->bytes();
    }
    return bytes;
}

std::size_t FineUndo::bytes() const {
    std::size_t bytes = sizeof(*this) + run.state.voxels.size() * sizeof(std::uint64_t);
    for (const auto& [brick, cells] : bricks) {
        bytes += sizeof(cells) + (cells == nullptr ? 0 : cells->bytes());
    }
    return bytes;
}

} // namespace vs::segment

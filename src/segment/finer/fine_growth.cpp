// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_growth.h"

#include "base/parallel.h"
#include "base/progress.h"
#include "base/timer.h"
#include "segment/finer/fine_recording.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <new>
#include <numeric>
#include <tuple>
#include <utility>

namespace vs::segment {

namespace {

constexpr int kNever = GrowthState::kNever;
// The most expansions at once, and the voxels after which no further one is tried.
constexpr int kMostExpansions = 1 << 14;
constexpr std::uint64_t kManyVoxels = 3'000'000;

using SeedAnswer = Frontier::SeedAnswer;

bool isBefore(glm::ivec3 a, glm::ivec3 b) { return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x); }

void makeUnique(std::vector<glm::ivec3>& voxels) {
    std::sort(voxels.begin(), voxels.end(), isBefore);
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
}

// The list of a brick's generations, made by whichever thread comes first; null: there is no memory.
std::uint32_t* generationsOf(HostBrick& brick) {
    std::uint32_t* list = brick.generations.load(std::memory_order_acquire);
    if (list == nullptr) {
        auto* made = new (std::nothrow) std::uint32_t[kBrickVoxels];
        if (made == nullptr) {
            return nullptr;
        }
        if (brick.generations.compare_exchange_strong(list, made, std::memory_order_acq_rel)) {
            list = made;
        } else {
            delete[] made;
        }
    }
    return list;
}

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
      bricks_(values_->field().geometry.dims), spread_(bricks_, values_->field().geometry.dims) {}

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

// --- seeds

SeedAnswer FineGrowth::answer(glm::ivec3 voxel, const FineRules& rules) const {
    const std::uint32_t brick = brickOf(voxel);
    const std::size_t cell = cellOf(voxel & (field::kBrick - 1));
    const auto cells = map_.find(brick);
    const std::uint32_t generation = cells == map_.end() ? 0 : cells->second->generation(cell);
    const bool isOwn = generation != 0 && cells->second->label(cell) == label_;
    if (generation != 0 && !(isOwn && int(generation) > run_.state.playhead)) {
        return isOwn ? SeedAnswer::Present : SeedAnswer::Refused;
    }
    if (!admitsByValue(voxel, rules)) {
        return SeedAnswer::Refused;
    }
    if (rules.constraints->hasFence()) {
        const bool isCut = (*rules.fence)({voxel, voxel + 1}).front() >= 0.5F;
        if (isCut != (rules.constraints->view == field::SculptureView::Probe)) {
            return SeedAnswer::Refused;
        }
    }
    const auto forbidden = rules.forbidden->find(brick);
    return forbidden != rules.forbidden->end() && has(*forbidden->second, cell) ? SeedAnswer::AdmittedAgain
                                                                                : SeedAnswer::Admitted;
}

int FineGrowth::enteringGeneration() const {
    return std::max({1, run_.state.playhead, std::min(run_.state.frozen, run_.state.playhead) + 1});
}

SeedCounts FineGrowth::addSeeds(std::span<const glm::ivec3> seeds, FineUndo* undo) {
    const Recording recording(undo, *this);
    std::vector<glm::ivec3> voxels;
    std::copy_if(seeds.begin(), seeds.end(), std::back_inserter(voxels),
                 [&](glm::ivec3 v) { return glm::all(glm::lessThan(glm::uvec3(v), glm::uvec3(dims()))); });
    SeedCounts counts;
    counts.refused = int(seeds.size() - voxels.size());
    const std::size_t offered = voxels.size();
    makeUnique(voxels);
    counts.present = int(offered - voxels.size());
    std::vector<glm::ivec3> added;
    auto forbidden = std::make_shared<ForbiddenBits>(*run_.forbidden);
    for (const glm::ivec3 voxel : voxels) {
        const SeedAnswer answer = this->answer(voxel, rules());
        if (answer == SeedAnswer::AdmittedAgain) {
            auto& bits = (*forbidden)[brickOf(voxel)];
            auto fewer = std::make_shared<CellBits>(*bits);
            const std::size_t cell = cellOf(voxel & (field::kBrick - 1));
            (*fewer)[cell / 64] &= ~(std::uint64_t(1) << cell % 64);
            bits = std::move(fewer);
        }
        if (answer == SeedAnswer::Admitted || answer == SeedAnswer::AdmittedAgain) {
            added.push_back(voxel);
        } else {
            ++(answer == SeedAnswer::Present ? counts.present : counts.refused);
        }
    }
    counts.added = int(added.size());
    if (!added.empty()) {
        truncate(run_.state.playhead);
        run_.forbidden = std::move(forbidden);
        enterSeeds(added);
        auto remembered = *run_.seeds;
        for (const glm::ivec3 voxel : voxels) {
            remembered.push_back({voxel, run_.state.extent});
        }
        run_.seeds = std::make_shared<const std::vector<Seed>>(std::move(remembered));
    }
    return counts;
}

void FineGrowth::enterSeeds(const std::vector<glm::ivec3>& voxels) {
    const int generation = enteringGeneration();
    std::map<std::uint32_t, std::vector<std::size_t>> byBrick;
    for (const glm::ivec3 voxel : voxels) {
        byBrick[brickOf(voxel)].push_back(cellOf(voxel & (field::kBrick - 1)));
    }
    for (const auto& [brick, cells] : byBrick) {
        const auto known = map_.find(brick);
        OpenCells open = known == map_.end() ? OpenCells() : known->second->opened();
        for (const std::size_t cell : cells) {
            open.generations[cell] = std::uint32_t(generation);
            open.labels[cell] = label_;
        }
        replaceCells(brick, open);
    }
    if (isValid_) {
        added_.insert(added_.end(), voxels.begin(), voxels.end());
    }
    run_.state.voxels.resize(std::size_t(generation));
    run_.state.voxels.back() += voxels.size();
    run_.state.extent = generation;
    run_.state.playhead = generation;
    run_.state.isFinished = false;
}

void FineGrowth::reinstateSeeds() {
    std::vector<glm::ivec3> voxels;
    for (const Seed& seed : *run_.seeds) {
        voxels.push_back(seed.voxel);
    }
    makeUnique(voxels);
    const FineRules rules = this->rules();
    std::erase_if(voxels, [&](glm::ivec3 v) { return answer(v, rules) != SeedAnswer::Admitted; });
    if (!voxels.empty()) {
        enterSeeds(voxels);
    }
}

std::vector<glm::ivec3> FineGrowth::nearestAdmitted(const std::vector<glm::dvec3>& places,
                                                    const Constraints& constraints) const {
    const FineFence fence = constraints.hasFence() ? fenceNow_() : FineFence();
    const bool keepsCutPart = constraints.view == field::SculptureView::Probe;
    const glm::dmat3 millimetres(values_->field().geometry.worldFromVoxel);
    std::vector<glm::ivec3> found;
    volume::visitType(values_->type(), [&](const auto* none) {
        const HostRules rules(none, glm::ivec3(4), values_->field(), constraints);
        for (const glm::dvec3& place : places) {
            const glm::ivec3 cell(glm::floor(place));
            const Box3 around{cell - 1, cell + 3};
            const auto values = values_->read(around);
            const auto here = rules.of(reinterpret_cast<decltype(none)>(values.data()));
            double nearest = std::numeric_limits<double>::infinity();
            glm::ivec3 best{0};
            forEachVoxel(Box3{cell, cell + 2}, [&](glm::ivec3 voxel, std::size_t) {
                const double apart = glm::length(millimetres * (glm::dvec3(voxel) - place));
                const bool isInside = glm::all(glm::lessThan(glm::uvec3(voxel), glm::uvec3(dims())));
                if (apart < nearest && isInside && here.admits(voxel - around.lo) &&
                    (!constraints.hasFence() ||
                     (fence(Box3{voxel, voxel + 1}).front() >= 0.5F) == keepsCutPart)) {
                    nearest = apart;
                    best = voxel;
                }
            });
            if (nearest < std::numeric_limits<double>::infinity()) {
                found.push_back(best);
            }
        }
    });
    return found;
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
    GrowthState& state = run_.state;
    const int before = state.playhead;
    const int last = before + std::clamp(state.extent - before, 0, std::max(generations, 0));
    int generation = before;
    for (auto count = voxelCount(); generation < last && count < mostVoxels; ++generation) {
        count += state.voxels[std::size_t(generation)];
    }
    state.playhead = generation;
    return generation - before;
}

// Takes back what has just been computed after the first generation by which there are so many voxels.
int FineGrowth::cutBack(std::uint64_t mostVoxels) {
    GrowthState& state = run_.state;
    int last = state.playhead;
    for (auto count = voxelCount(); last > 1 && count - state.voxels[std::size_t(last - 1)] >= mostVoxels;
         --last) {
        count -= state.voxels[std::size_t(last - 1)];
    }
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

// Voxels grown by each expansion tried.
std::vector<std::uint64_t> FineGrowth::expand(int expansions) {
    bricks_.goBy(rules());
    if (!std::exchange(isValid_, false)) { // until all has gone well
        collect();
    }
    for (const glm::ivec3 voxel : added_) {
        spread_.add(voxel);
    }
    added_.clear();
    std::vector<std::uint64_t> grown;
    std::atomic<bool> isOutOfMemory = false;
    const Connectivity connectivity = run_.state.constraints.connectivity;
    volume::visitType(values_->type(), [&](const auto* none) {
        const FinePairs<std::remove_cv_t<std::remove_pointer_t<decltype(none)>>> pairs(bricks_);
        spread_.expand(
            pairs, {connectivity, run_.state.extent + 1, expansions, kManyVoxels},
            [&](const TileOfBrick& tile, std::uint32_t place, std::uint32_t generation) {
                if (std::uint32_t* list = generationsOf(*tile.brick)) {
                    list[std::size_t(tile.tile) << 9U | place] = generation;
                } else { // threads must not throw
                    isOutOfMemory = true;
                }
            },
            grown);
    });
    if (isOutOfMemory) {
        throw std::bad_alloc();
    }
    commit();
    isValid_ = true;
    if (bricks_.memoryBytes() > frontBytes_) {
        bricks_.letGoBehind(spread_.front());
    }
    return grown;
}

// All voxels of the segment at work, other than frozen ones, are the newest.
void FineGrowth::collect() {
    bricks_.forget();
    spread_.clear();
    added_.clear();
    for (const std::uint32_t number : holding(run_.state.frozen)) {
        reportProgress();
        const FineCells& cells = *map_.at(number);
        std::array<Slices, 64> grown{};
        cells.forEachGrown([&](std::size_t cell, std::uint32_t generation) {
            if (int(generation) > run_.state.frozen && cells.label(cell) == label_) {
                slices::set(grown[cell >> 9U], std::uint32_t(cell & 511U));
            }
        });
        HostBrick& brick = bricks_.brick(number);
        for (std::uint32_t tile = 0; tile < grown.size(); ++tile) {
            if (grown[tile].any() != 0) {
                spread_.add({&brick, tile}, grown[tile], run_.state.constraints.connectivity);
            }
        }
    }
}

// What has joined in the last expansions becomes part of what has grown.
void FineGrowth::commit() {
    struct Joined {
        std::uint32_t brick = 0;
        FineCellsPtr before;
        FineCellsPtr after;
        std::unique_ptr<const std::uint32_t[]> generations;
        std::vector<std::pair<std::size_t, Slices>> tiles;
    };
    std::vector<Joined> joined;
    bricks_.takeJoined([&](HostBrick& brick, GenerationSpan) {
        const auto known = map_.find(brick.number);
        Joined& one = joined.emplace_back();
        one.brick = brick.number;
        one.before = known == map_.end() ? FineCellsPtr() : known->second;
        one.generations.reset(brick.generations.exchange(nullptr));
        for (std::size_t tile = 0; tile < brick.tiles.size(); ++tile) {
            if (brick.hasJoined[tile] != 0) {
                one.tiles.emplace_back(tile, brick.tiles[tile].joined);
            }
        }
    });
    const auto put = [&](int n) {
        Joined& one = joined[std::size_t(n)];
        OpenCells open = one.before == nullptr ? OpenCells() : one.before->opened();
        for (const auto& [tile, slices] : one.tiles) {
            slices::forEach(slices, [&, first = tile << 9U](std::uint32_t place) {
                open.generations[first | place] = one.generations[first | place];
                open.labels[first | place] = label_;
            });
        }
        one.after = std::make_shared<const FineCells>(open);
    };
    constexpr int kWorthThreads = 16;
    if (int(joined.size()) < kWorthThreads) {
        for (int n = 0; n < int(joined.size()); ++n) {
            put(n);
        }
    } else {
        inParallel(int(joined.size()), put);
    }
    for (Joined& one : joined) {
        if (recording_ != nullptr) {
            recording_->bricks.try_emplace(one.brick, one.before);
        }
        changed_.insert(one.brick);
        map_[one.brick] = std::move(one.after);
    }
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

std::uint64_t FineGrowth::voxelCount() const {
    const GrowthState& state = run_.state;
    return std::accumulate(state.voxels.begin(), state.voxels.begin() + state.playhead, std::uint64_t(0));
}

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
    std::size_t bytes = bricks_.memoryBytes();
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

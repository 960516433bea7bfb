// SPDX-License-Identifier: Apache-2.0
// What changes segments at the finest level other than growing, and takes changes back.
#include "segment/finer/fine_growth.h"
#include "segment/finer/fine_recording.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

namespace vs::segment {

namespace {

constexpr int kAll = std::numeric_limits<int>::max();

} // namespace

void FineGrowth::noteChanged(std::uint32_t brick) {
    static std::atomic<std::uint64_t> last{0};
    changed_.insert(brick);
    revision_ = ++last;
}

// A brick becomes what it was not; the record keeps what it was.
void FineGrowth::replaceCells(std::uint32_t brick, const OpenCells& open) {
    auto cells = std::make_shared<const FineCells>(open);
    const auto known = map_.find(brick);
    if (recording_ != nullptr) {
        recording_->bricks.try_emplace(brick, known == map_.end() ? FineCellsPtr() : known->second);
    }
    noteChanged(brick);
    if (!cells->isEmpty()) {
        map_[brick] = std::move(cells);
    } else if (known != map_.end()) {
        map_.erase(known);
    }
}

void FineGrowth::dropCells(std::uint32_t brick) {
    const auto known = map_.find(brick);
    if (recording_ != nullptr) {
        recording_->bricks.try_emplace(brick, known->second);
    }
    noteChanged(brick);
    map_.erase(known);
}

void FineGrowth::putBack(const std::map<std::uint32_t, FineCellsPtr>& bricks) {
    for (const auto& [brick, cells] : bricks) {
        noteChanged(brick);
        if (cells == nullptr) {
            map_.erase(brick);
        } else {
            map_[brick] = cells;
        }
    }
}

// After a call that threw: all that it changed is noted.
void FineGrowth::takeBack(const FineUndo& noted) {
    isValid_ = false;
    if (noted.label != label_) {
        others_[label_] = std::move(run_);
        others_.erase(noted.label);
        label_ = noted.label;
    }
    putBack(noted.bricks);
    run_ = noted.run;
}

void FineGrowth::erase(const Bricks& among, int last,
                       const std::function<bool(std::uint32_t, std::size_t)>& isTaken) {
    for (const std::uint32_t brick : among) {
        const FineCellsPtr cells = map_.at(brick);
        OpenCells open;
        bool isChanged = false;
        cells->forEachGrown([&](std::size_t cell, std::uint32_t generation) {
            if (cells->label(cell) == label_ && int(generation) > last && isTaken(brick, cell)) {
                if (!std::exchange(isChanged, true)) {
                    open = cells->opened();
                }
                open.erase(cell);
                if (generation <= run_.state.voxels.size()) {
                    --run_.state.voxels[generation - 1];
                }
            }
        });
        if (isChanged) {
            replaceCells(brick, open);
            isValid_ = false;
        }
    }
}

void FineGrowth::eraseAfter(int last) {
    Bricks inPart;
    for (const std::uint32_t brick : holding(last)) {
        const auto& spans = map_.at(brick)->spans();
        if (spans.size() == 1 && int(spans.begin()->second.first) > last) {
            dropCells(brick);
        } else {
            inPart.push_back(brick);
        }
    }
    erase(inPart, last, [](std::uint32_t, std::size_t) { return true; });
    isValid_ = false;
}

void FineGrowth::truncate(int last) {
    GrowthState& state = run_.state;
    if (last >= state.extent) {
        return;
    }
    auto seeds = *run_.seeds;
    std::erase_if(seeds, [&](const Seed& seed) { return seed.generation > last; });
    eraseAfter(last);
    state.extent = last;
    state.frozen = std::min(state.frozen, last);
    state.voxels.resize(std::size_t(last));
    state.isFinished = false;
    if (last == 0) {
        state.consistentFrom = 0;
    } else if (last < state.consistentFrom) {
        state.consistentFrom = kAll; // what stays may have been reached by what went
    }
    run_.seeds = std::make_shared<const std::vector<Seed>>(std::move(seeds));
}

std::unordered_map<std::uint32_t, CellBits> FineGrowth::flood(FineBricks& region,
                                                              const std::vector<glm::ivec3>& seeds,
                                                              Connectivity connectivity, int expansions,
                                                              int& found) const {
    HostSpread spread(region, dims());
    for (const glm::ivec3 seed : seeds) {
        const TileOfBrick tile = region.tileOf(seed);
        const std::uint32_t place = slices::placeOf(seed & 7);
        if (slices::has(tile->open, place)) {
            spread.add(seed);
            region.join(tile, place, 1);
        }
    }
    std::vector<std::uint64_t> joined;
    volume::visitType(values_->type(), [&](const auto* none) {
        const FineRulesLeft<std::remove_cv_t<std::remove_pointer_t<decltype(none)>>> left(region);
        spread.expand(
            left, {connectivity, 1, expansions}, [](const TileOfBrick&, std::uint32_t, std::uint32_t) {},
            joined);
    });
    found = int(std::count_if(joined.begin(), joined.end(), [](std::uint64_t n) { return n > 0; }));
    std::unordered_map<std::uint32_t, CellBits> reached;
    region.takeJoined([&](const HostBrick& brick, GenerationSpan) {
        CellBits& bits = reached[brick.number];
        for (std::size_t tile = 0; tile < brick.tiles.size(); ++tile) {
            if (brick.hasJoined[tile] != 0) {
                const auto& slices = brick.tiles[tile].joined.z;
                std::copy(slices.begin(), slices.end(), bits.begin() + std::ptrdiff_t(tile * 8));
            }
        }
    });
    return reached;
}

// Live mode: keeps what can be reached from the seeds under the present rules, within what has grown.
void FineGrowth::retract() {
    if (run_.state.extent == 0) {
        return;
    }
    FineBricksOfSegment region(dims(), run_.state.frozen);
    region.goBy(rules());
    std::vector<glm::ivec3> seeds;
    for (const Seed& seed : *run_.seeds) {
        seeds.push_back(seed.voxel);
    }
    int found = 0;
    const auto reached = flood(region, seeds, run_.state.constraints.connectivity, kAll, found);
    erase(holding(run_.state.frozen), run_.state.frozen, [&](std::uint32_t brick, std::size_t cell) {
        const auto bits = reached.find(brick);
        return bits == reached.end() || !has(bits->second, cell);
    });
}

int FineGrowth::absorb(std::span<const glm::ivec3> voxels, int expansions, FineUndo* undo) {
    const Recording recording(undo, *this);
    truncate(run_.state.playhead);
    FineBricksOfSegment region(dims(), 0);
    FineRules own = rules();
    own.constraints = nullptr;
    region.goBy(own);
    std::vector<glm::ivec3> from;
    std::copy_if(voxels.begin(), voxels.end(), std::back_inserter(from),
                 [&](glm::ivec3 v) { return glm::all(glm::lessThan(glm::uvec3(v), glm::uvec3(dims()))); });
    int found = 0;
    const auto reached = flood(region, from, run_.state.constraints.connectivity, expansions, found);
    auto forbidden = std::make_shared<ForbiddenBits>(*run_.forbidden);
    Bricks among;
    for (const auto& [brick, bits] : reached) {
        among.push_back(brick);
        auto& known = (*forbidden)[brick];
        auto more = std::make_shared<CellBits>(known == nullptr ? CellBits{} : *known);
        for (std::size_t i = 0; i < bits.size(); ++i) {
            (*more)[i] |= bits[i];
        }
        known = std::move(more);
    }
    erase(among, 0, [&](std::uint32_t brick, std::size_t cell) { return has(reached.at(brick), cell); });
    run_.forbidden = std::move(forbidden);
    isValid_ = false;
    run_.state.isFinished = false;
    run_.state.consistentFrom = kAll;
    return found;
}

void FineGrowth::edit(std::span<const BrickEdit> edits, FineUndo* undo) {
    const Recording recording(undo, *this);
    GrowthState& state = run_.state;
    truncate(state.playhead);
    const int generation = std::max(1, state.playhead);
    state.voxels.resize(std::size_t(generation));
    for (const BrickEdit& edit : edits) {
        const auto known = map_.find(edit.brick);
        OpenCells open = known == map_.end() ? OpenCells() : known->second->opened();
        bool isChanged = false;
        for (std::size_t cell = 0; cell < kBrickVoxels; ++cell) {
            const std::uint32_t grown = open.generation(cell);
            if (grown != 0 && open.label(cell) == label_ && has(edit.taken, cell)) {
                --state.voxels[grown - 1];
                open.erase(cell);
                isChanged = true;
            } else if (grown == 0 && has(edit.given, cell)) {
                open.set(cell, std::uint32_t(generation), label_);
                ++state.voxels[std::size_t(generation - 1)];
                isChanged = true;
            }
        }
        if (isChanged) {
            replaceCells(edit.brick, open);
        }
    }
    state.extent = generation;
    state.playhead = generation;
    freeze();
}

// What there is now came of an edit: it does not grow.
void FineGrowth::freeze() {
    run_.state.frozen = run_.state.extent;
    run_.state.isFinished = true;
    run_.seeds = std::make_shared<const std::vector<Seed>>();
    isValid_ = false;
}

void FineGrowth::reset(FineUndo* undo) {
    const Recording recording(undo, *this);
    run_.state.playhead = 0;
    truncate(0);
    run_.seeds = std::make_shared<const std::vector<Seed>>();
    run_.state.consistentFrom = 0;
    run_.forbidden = std::make_shared<const ForbiddenBits>();
    isValid_ = false;
}

void FineGrowth::activate(std::uint8_t label, FineUndo* undo) {
    const Recording recording(undo, *this);
    if (label == label_) {
        return;
    }
    truncate(run_.state.playhead);
    others_[label_] = std::exchange(run_, std::exchange(others_[label], {}));
    others_.erase(label);
    label_ = label;
    isValid_ = false;
}

void FineGrowth::undo(const FineUndo& undo) {
    if (undo.label == 0) {
        return;
    }
    if (undo.label == label_) { // calls without a record may have gone on growing
        eraseAfter(std::min(undo.run.state.extent, run_.state.extent));
    }
    takeBack(undo);
}

} // namespace vs::segment

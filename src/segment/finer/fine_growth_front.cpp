// SPDX-License-Identifier: Apache-2.0
// How growth at the finest level goes on: its front, and what has joined.
#include "segment/finer/fine_growth.h"

#include "base/check.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "volume/grid/visit_type.h"

#include <atomic>
#include <limits>
#include <new>
#include <utility>

namespace vs::segment {

namespace {

// The voxels after which no further expansion is tried.
constexpr std::uint64_t kManyVoxels = 3'000'000;

} // namespace

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
    const auto first = std::uint32_t(run_.state.extent + 1);
    VS_CHECK(expansions <= std::numeric_limits<std::uint16_t>::max()); // when voxels joined is told so far
    volume::visitType(values_->type(), [&](const auto* none) {
        const FineRulesLeft<std::remove_cv_t<std::remove_pointer_t<decltype(none)>>> left(bricks_);
        spread_.expand(
            left, {connectivity, int(first), expansions, kManyVoxels},
            [&](const TileOfBrick& tile, std::uint32_t place, std::uint32_t generation) {
                std::uint16_t*& when = tile.brick->whenJoined[tile.tile]; // one thread is at a tile
                when = when != nullptr ? when : lists_.take();
                if (when != nullptr) {
                    when[place] = std::uint16_t(generation - first);
                } else { // threads must not throw
                    isOutOfMemory = true;
                }
            },
            grown);
    });
    if (isOutOfMemory) {
        throw std::bad_alloc();
    }
    commit(first);
    isValid_ = true;
    if (bricks_.memoryBytes() > frontBytes_) {
        bricks_.letGoBehind(spread_.front());
    }
    return grown;
}

// All voxels of the segment at work, other than frozen ones, are the newest.
void FineGrowth::collect() {
    bricks_.forget();
    lists_.takeBackAll();
    spread_.clear();
    added_.clear();
    for (const std::uint32_t number : holding(run_.state.frozen)) {
        reportProgress();
        const FineCells& cells = *map_.at(number);
        std::array<Slices, kBrickTiles> grown{};
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

// What has joined in the last expansions, of which the first made generation `from`, becomes part of what has
// grown.
void FineGrowth::commit(std::uint32_t from) {
    struct Joined {
        std::uint32_t brick = 0;
        FineCellsPtr before;
        FineCellsPtr after;
        FineCells::Joined voxels;
    };
    std::vector<Joined> joined;
    bricks_.takeJoined([&](HostBrick& brick, GenerationSpan span) {
        const auto known = map_.find(brick.number);
        Joined& one = joined.emplace_back();
        one.brick = brick.number;
        one.before = known == map_.end() ? FineCellsPtr() : known->second;
        one.voxels = {label_, span, from, {}};
        for (std::size_t tile = 0; tile < brick.tiles.size(); ++tile) {
            if (brick.hasJoined[tile] != 0) {
                one.voxels.tiles.push_back({tile, brick.tiles[tile].joined, brick.whenJoined[tile]});
            }
        }
    });
    const auto put = [&](int n) {
        Joined& one = joined[std::size_t(n)];
        one.after = std::make_shared<const FineCells>(one.before.get(), one.voxels);
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
        noteChanged(one.brick);
        map_[one.brick] = std::move(one.after);
    }
    lists_.takeBackAll();
}

} // namespace vs::segment

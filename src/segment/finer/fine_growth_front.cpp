// SPDX-License-Identifier: Apache-2.0
// How growth at the finest level goes on: its front, and what has joined.
#include "segment/finer/fine_growth.h"

#include "base/parallel.h"
#include "base/progress.h"
#include "volume/grid/visit_type.h"

#include <atomic>
#include <new>
#include <utility>

namespace vs::segment {

namespace {

// The voxels after which no further expansion is tried.
constexpr std::uint64_t kManyVoxels = 3'000'000;

// The list of a tile's generations; null: there is no memory. One thread at a time looks at a tile.
std::uint32_t* generationsOf(const TileOfBrick& tile) {
    auto& list = tile.brick->generations[tile.tile];
    if (list == nullptr) {
        list.reset(new (std::nothrow) std::uint32_t[kTileVoxels]);
    }
    return list.get();
}

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
    volume::visitType(values_->type(), [&](const auto* none) {
        const FineRulesLeft<std::remove_cv_t<std::remove_pointer_t<decltype(none)>>> left(bricks_);
        spread_.expand(
            left, {connectivity, run_.state.extent + 1, expansions, kManyVoxels},
            [&](const TileOfBrick& tile, std::uint32_t place, std::uint32_t generation) {
                if (std::uint32_t* list = generationsOf(tile)) {
                    list[place] = generation;
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

// What has joined in the last expansions becomes part of what has grown.
void FineGrowth::commit() {
    struct Joined {
        std::uint32_t brick = 0;
        FineCellsPtr before;
        FineCellsPtr after;
        struct Tile {
            std::size_t tile = 0;
            Slices joined;
            std::unique_ptr<const std::uint32_t[]> generations;
        };
        std::vector<Tile> tiles;
    };
    std::vector<Joined> joined;
    bricks_.takeJoined([&](HostBrick& brick, GenerationSpan) {
        const auto known = map_.find(brick.number);
        Joined& one = joined.emplace_back();
        one.brick = brick.number;
        one.before = known == map_.end() ? FineCellsPtr() : known->second;
        for (std::size_t tile = 0; tile < brick.tiles.size(); ++tile) {
            if (brick.hasJoined[tile] != 0) {
                one.tiles.push_back(
                    {tile, brick.tiles[tile].joined, std::exchange(brick.generations[tile], nullptr)});
            }
        }
    });
    const auto put = [&](int n) {
        Joined& one = joined[std::size_t(n)];
        if (one.before == nullptr) {
            std::vector<FineCells::Tile> tiles;
            for (const Joined::Tile& tile : one.tiles) {
                tiles.push_back({tile.tile, tile.joined, tile.generations.get()});
            }
            one.after = std::make_shared<const FineCells>(tiles, label_);
            return;
        }
        OpenCells open = one.before->opened();
        for (const Joined::Tile& tile : one.tiles) {
            slices::forEach(tile.joined, [&](std::uint32_t place) {
                open.set(tile.tile * kTileVoxels + place, tile.generations[place], label_);
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
        noteChanged(one.brick);
        map_[one.brick] = std::move(one.after);
    }
}

} // namespace vs::segment

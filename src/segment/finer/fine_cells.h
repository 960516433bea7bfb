// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "segment/growth/brick_table.h"
#include "segment/growth/slices.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <variant>
#include <vector>

namespace vs::segment {

inline constexpr std::size_t kBrickVoxels = std::size_t(field::kBrick) * field::kBrick * field::kBrick;
inline constexpr std::size_t kBrickTiles = 64;
inline constexpr std::size_t kTileVoxels = kBrickVoxels / kBrickTiles;

// Where a voxel of a brick of 32^3 stands in lists of all of them: tile by tile of 8^3, x fastest in each, as
// growth goes through them.
constexpr std::size_t cellOf(glm::ivec3 inBrick) {
    return std::size_t((inBrick.x >> 3) | (inBrick.y >> 3) << 2 | (inBrick.z >> 3) << 4) << 9U |
           std::size_t((inBrick.x & 7) | (inBrick.y & 7) << 3 | (inBrick.z & 7) << 6);
}
constexpr glm::ivec3 voxelOfCell(std::size_t cell) {
    const auto tile = int(cell >> 9U);
    const auto place = int(cell & 511U);
    return {(tile & 3) << 3 | (place & 7), (tile >> 2 & 3) << 3 | (place >> 3 & 7),
            (tile >> 4) << 3 | place >> 6};
}

// Where in a list of some of a brick's tiles each of them is: 0, not there, or 1, 2, ...
class TileSlots {
public:
    // The place of a cell among those of the tiles listed, one tile after the other; none: its tile is not.
    static constexpr std::size_t kNone = ~std::size_t(0);
    [[nodiscard]] std::size_t placeOf(std::size_t cell) const {
        const std::size_t slot = slots_[cell / kTileVoxels];
        return slot == 0 ? kNone : (slot - 1) * kTileVoxels + cell % kTileVoxels;
    }
    [[nodiscard]] std::size_t slotOf(std::size_t tile) const { return slots_[tile]; }
    // Lists a tile that is not there yet.
    void add(std::size_t tile) { slots_[tile] = std::uint8_t(++count_); }
    [[nodiscard]] std::size_t count() const { return count_; }

private:
    std::array<std::uint8_t, kBrickTiles> slots_{};
    std::size_t count_ = 0;
};

// What has grown in a brick, while it changes: of each voxel its generation (0: none) and its segment. Tiles
// in which nothing has take no room.
class OpenCells {
public:
    [[nodiscard]] std::uint32_t generation(std::size_t cell) const {
        const std::size_t place = slots_.placeOf(cell);
        return place == TileSlots::kNone ? 0 : generations_[place];
    }
    // The segment of a voxel that has grown.
    [[nodiscard]] std::uint8_t label(std::size_t cell) const { return labels_[slots_.placeOf(cell)]; }
    void set(std::size_t cell, std::uint32_t generation, std::uint8_t label) {
        const std::size_t place = made(cell);
        generations_[place] = generation;
        labels_[place] = label;
    }
    void erase(std::size_t cell) {
        const std::size_t place = slots_.placeOf(cell);
        if (place != TileSlots::kNone) {
            generations_[place] = 0;
        }
    }

private:
    friend class FineCells;
    std::size_t made(std::size_t cell) {
        if (slots_.slotOf(cell / kTileVoxels) == 0) {
            slots_.add(cell / kTileVoxels);
            generations_.resize(slots_.count() * kTileVoxels);
            labels_.resize(slots_.count() * kTileVoxels);
        }
        return slots_.placeOf(cell);
    }

    TileSlots slots_;
    std::vector<std::uint32_t> generations_;
    std::vector<std::uint8_t> labels_;
};

// What has grown in a brick, as it is kept: it never changes. Tiles in which nothing has take no room.
// Generations that lie next to one another, as those in a brick do, take a byte a voxel, and labels take one
// byte in all where there is but one.
class FineCells {
public:
    explicit FineCells(const OpenCells& open);
    // What has joined a segment in a brick: in some of its tiles which voxels, and in which generations,
    // counted from `from`.
    struct Joined {
        struct Tile {
            std::size_t tile = 0;
            Slices voxels;
            const std::uint16_t* when = nullptr; // of all voxels of the tile; those of others are not read
        };
        std::uint8_t label = 0;
        GenerationSpan span; // of all that has joined
        std::uint32_t from = 0;
        std::vector<Tile> tiles;
    };
    // With what had grown before, if anything had.
    FineCells(const FineCells* before, const Joined& joined);

    [[nodiscard]] bool isEmpty() const { return spans_.empty(); }
    [[nodiscard]] std::uint32_t generation(std::size_t cell) const {
        const std::size_t place = slots_.placeOf(cell);
        if (place == TileSlots::kNone) {
            return 0;
        }
        return std::visit(
            [&](const auto& entries) {
                const std::uint32_t entry = entries[place];
                return entry == 0 ? 0U : base_ + entry;
            },
            entries_);
    }
    // The segment of a voxel that has grown.
    [[nodiscard]] std::uint8_t label(std::size_t cell) const {
        return labels_[labels_.size() == 1 ? 0 : slots_.placeOf(cell)];
    }
    // Calls f(cell, generation) for each voxel that has grown.
    template <typename F>
    void forEachGrown(F&& f) const {
        std::visit(
            [&](const auto& entries) {
                for (std::size_t tile = 0; tile < kBrickTiles; ++tile) {
                    if (slots_.slotOf(tile) == 0) {
                        continue;
                    }
                    const std::size_t first = tile * kTileVoxels;
                    const auto* own = entries.data() + slots_.placeOf(first);
                    for (std::size_t row = 0; row < kTileVoxels; row += 8) {
                        auto any = own[row];
                        for (std::size_t n = row + 1; n < row + 8; ++n) {
                            any |= own[n];
                        }
                        for (std::size_t n = row; any != 0 && n < row + 8; ++n) {
                            if (own[n] != 0) {
                                f(first + n, base_ + own[n]);
                            }
                        }
                    }
                }
            },
            entries_);
    }
    // Calls f(tile, entries, base) for each tile in which something has grown: an entry for each of its
    // voxels, 0 where nothing has, which is a generation less that base.
    template <typename F>
    void visitTiles(F&& f) const {
        std::visit(
            [&](const auto& entries) {
                for (std::size_t tile = 0; tile < kBrickTiles; ++tile) {
                    if (slots_.slotOf(tile) != 0) {
                        f(tile, entries.data() + slots_.placeOf(tile * kTileVoxels), base_);
                    }
                }
            },
            entries_);
    }
    // Calls f(generationOf), a function that gives the generation of a cell, 0 where nothing has grown.
    template <typename F>
    void visitGenerations(F&& f) const {
        std::visit(
            [&](const auto& entries) {
                f([&](std::size_t cell) -> std::uint32_t {
                    const std::size_t place = slots_.placeOf(cell);
                    const std::uint32_t entry = place == TileSlots::kNone ? 0U : entries[place];
                    return entry == 0 ? 0U : base_ + entry;
                });
            },
            entries_);
    }
    // The generations of each segment that has voxels here.
    [[nodiscard]] const std::map<std::uint8_t, GenerationSpan>& spans() const { return spans_; }
    [[nodiscard]] bool holds(std::uint8_t label, int after) const {
        const auto found = spans_.find(label);
        return found != spans_.end() && int(found->second.last) > after;
    }
    // Whether nothing has grown in a tile.
    [[nodiscard]] bool isTileEmpty(std::size_t tile) const { return slots_.slotOf(tile) == 0; }
    [[nodiscard]] OpenCells opened() const;
    [[nodiscard]] std::size_t bytes() const;

private:
    template <typename Entry>
    std::vector<Entry> entriesOf(const OpenCells& open) const;
    template <typename F>
    void setEntries(std::uint32_t last, F&& entriesOf);
    template <typename Entry>
    void add(const Joined& joined, std::vector<Entry>& entries) const;

    TileSlots slots_;        // of the tiles in which something has grown
    std::uint32_t base_ = 0; // generation = this + entry
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<std::uint32_t>> entries_;
    std::vector<std::uint8_t> labels_;
    std::map<std::uint8_t, GenerationSpan> spans_;
};

using FineCellsPtr = std::shared_ptr<const FineCells>;           // null: nothing has grown
using FineMap = std::unordered_map<std::uint32_t, FineCellsPtr>; // by number of the brick; never null

// A bit for each voxel of a brick, in the order of cellOf().
using CellBits = std::array<std::uint64_t, kBrickVoxels / 64>;
inline bool has(const CellBits& bits, std::size_t cell) { return (bits[cell / 64] >> cell % 64 & 1U) != 0; }
inline void set(CellBits& bits, std::size_t cell) { bits[cell / 64] |= std::uint64_t(1) << cell % 64; }

} // namespace vs::segment

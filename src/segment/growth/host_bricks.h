// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/frontier.h"
#include "segment/growth/slices.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace vs::segment {

// What spreading on the host keeps of a tile of 8^3 voxels.
struct alignas(64) HostTile {
    std::array<Slices, 2> newest; // of two generations, each read while the other is written
    Slices open;                  // what may be joined yet, as far as is known
    Slices joined;                // what has, and is not written into the set's own bits yet
};

// What it keeps of a brick.
struct HostBrick {
    std::array<HostTile, 64> tiles;
    // Which of the 27 tiles around one (bit (dx + 1) + 3 (dy + 1) + 9 (dz + 1)) have newest voxels that the
    // next expansion is to spread from into it; 0: it is not on the list of the next expansion.
    std::array<std::uint32_t, 64> around{};
    std::array<std::uint8_t, 64> isTested{};  // whether the rules were asked about all that is open
    std::array<std::uint8_t, 64> hasJoined{}; // whether something has
    std::uint32_t number = 0;
    glm::ivec3 place{0};     // in bricks
    GenerationSpan joinedIn; // the generations of what has joined; 0, 0: nothing has
    std::uint64_t madeFor = 0;
    // Where whoever spreads keeps when voxels of each tile joined; null until one does.
    std::array<std::uint16_t*, 64> whenJoined{};
    // The values that rules ask for, where whoever opens it keeps them until they do.
    std::shared_ptr<const std::vector<std::byte>> values;
};

// A tile, by its brick.
struct TileOfBrick {
    HostBrick* brick = nullptr;
    std::uint32_t tile = 0; // x + 4 y + 16 z

    explicit operator bool() const { return brick != nullptr; }
    [[nodiscard]] HostTile& operator*() const { return brick->tiles[tile]; }
    [[nodiscard]] HostTile* operator->() const { return &brick->tiles[tile]; }
    [[nodiscard]] bool isTested() const { return brick->isTested[tile] != 0; }
    [[nodiscard]] std::uint32_t& around() const { return brick->around[tile]; }
    [[nodiscard]] std::uint32_t number() const { return brick->number << 6U | tile; } // in the whole grid
    [[nodiscard]] glm::ivec3 origin() const {
        return brick->place * field::kBrick +
               8 * glm::ivec3(int(tile & 3U), int(tile >> 2U & 3U), int(tile >> 4U));
    }
};

// The places of the 27 tiles, or voxels, around one.
inline constexpr auto kOffsets = [] {
    std::array<glm::ivec3, 27> offsets{};
    for (int n = 0; n < 27; ++n) {
        offsets[std::size_t(n)] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    }
    return offsets;
}();
inline constexpr std::uint32_t kItself = 13; // among the 27

// What a set may spread into, brick by brick: each is made when it is first asked for. Internal to this
// folder.
class HostBricks {
public:
    explicit HostBricks(const SeedMap& seedMap) : HostBricks(seedMap.dims()) {}
    explicit HostBricks(glm::ivec3 dims);
    virtual ~HostBricks() = default;
    HostBricks(const HostBricks&) = delete;
    HostBricks& operator=(const HostBricks&) = delete;

    // From now on bricks are made anew.
    void forget();

    // A brick by its number. Throws std::bad_alloc, and whatever makes it open.
    HostBrick& brick(std::uint32_t number);
    // A tile beside one; none outside the grid.
    TileOfBrick near(const TileOfBrick& tile, glm::ivec3 offset) {
        const glm::ivec3 place = placeOfTile(tile.tile) + offset;
        const auto inBrick = std::uint32_t((place.x & 3) | (place.y & 3) << 2 | (place.z & 3) << 4);
        const bool isInBrick = ((place.x | place.y | place.z) & ~3) == 0;
        return isInBrick ? TileOfBrick{tile.brick, inBrick} : across(*tile.brick, place >> 2, inBrick);
    }
    // One of the 27 tiles around one.
    TileOfBrick near(const TileOfBrick& tile, std::uint32_t n) { return near(tile, kOffsets[n]); }
    // The tile that a voxel lies in.
    TileOfBrick tileOf(glm::ivec3 voxel);

    // A voxel of a tile joins.
    void join(const TileOfBrick& tile, std::uint32_t place, int generation) {
        slices::clear(tile->open, place);
        slices::set(tile->joined, place);
        tile.brick->hasJoined[tile.tile] = 1;
        noteJoined(*tile.brick, generation);
    }
    // Takes note that something of a brick has joined.
    void noteJoined(HostBrick& brick, int generation) {
        if (brick.joinedIn.first == 0) {
            joined_.push_back(&brick); // there is room
            brick.joinedIn.first = std::uint32_t(generation);
        }
        brick.joinedIn.last = std::uint32_t(generation);
    }
    // Writes what has joined into a plane of the seed map's layout, and hands out the bricks' numbers and
    // spans.
    template <typename F>
    void writeJoined(std::uint32_t* plane, F&& noteSpan) noexcept {
        for (HostBrick* brick : joined_) {
            writeJoined(*brick, plane);
            noteSpan(brick->number, std::exchange(brick->joinedIn, {}));
        }
        joined_.clear();
    }

    // Hands out the bricks in which something has joined, with their spans; after that nothing has.
    template <typename F>
    void takeJoined(F&& take) {
        for (HostBrick* brick : joined_) {
            take(*brick, std::exchange(brick->joinedIn, {}));
            brick->whenJoined.fill(nullptr);
            for (std::size_t tile = 0; tile < brick->tiles.size(); ++tile) {
                if (std::exchange(brick->hasJoined[tile], std::uint8_t(0)) != 0) {
                    brick->tiles[tile].joined = {};
                }
            }
        }
        joined_.clear();
    }
    // Lets go of all bricks but those listed, in which nothing may have joined; they can be made again.
    void keepOnly(const std::vector<HostBrick*>& needed);
    [[nodiscard]] bool isMade(std::uint32_t number) const { return bricks_[number] != nullptr; }

    [[nodiscard]] std::size_t madeBytes() const { return made_ * sizeof(HostBrick); }
    [[nodiscard]] std::size_t bytes() const {
        return made_ * sizeof(HostBrick) + bricks_.size() * sizeof(bricks_[0]);
    }

    static constexpr glm::ivec3 placeOfTile(std::uint32_t tile) {
        return {int(tile & 3U), int(tile >> 2U & 3U), int(tile >> 4U)};
    }

protected:
    // Says what is open in a brick, and whether that has been tested.
    virtual void open(HostBrick& brick) = 0;
    // A brick that was made, or null.
    [[nodiscard]] const HostBrick* found(glm::ivec3 voxel) const {
        const glm::ivec3 place = voxel / field::kBrick;
        return bricks_[std::size_t((place.z * brickDims_.y + place.y) * brickDims_.x + place.x)].get();
    }

private:
    TileOfBrick across(const HostBrick& from, const glm::ivec3& step, std::uint32_t tile);
    HostBrick& brickAt(std::uint32_t number, glm::ivec3 place);
    static void writeJoined(HostBrick& brick, std::uint32_t* plane) noexcept;

    glm::ivec3 brickDims_;
    std::vector<std::unique_ptr<HostBrick>> bricks_;
    std::size_t made_ = 0;
    std::vector<HostBrick*> joined_;
    std::uint64_t present_ = 1;
};

// The voxels that a segment may grow into: those in the grid that have not grown in any, are not forbidden
// and not beyond the fence. The rules by their values are left to be tested.
class BricksToGrowInto final : public HostBricks {
public:
    using HostBricks::HostBricks;
    // Both must stay until the next call.
    void goBy(const SeedMap& seedMap, const Frontier::Rules& rules) {
        seedMap_ = &seedMap;
        rules_ = rules;
    }

private:
    void open(HostBrick& brick) override;
    void closeBehindFence(HostBrick& brick) const;

    const SeedMap* seedMap_ = nullptr;
    Frontier::Rules rules_;
};

// The voxels of a region, a plane of the seed map's layout; nothing is left to be tested.
class BricksOfRegion final : public HostBricks {
public:
    BricksOfRegion(const SeedMap& seedMap, const std::uint32_t* region)
        : HostBricks(seedMap), region_(region) {}

private:
    void open(HostBrick& brick) override;

    const std::uint32_t* region_;
};

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/crew.h"
#include "segment/growth/host_bricks.h"
#include "segment/growth/host_rules.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace vs::segment {

// The way from a voxel to a neighbour.
struct Way {
    glm::ivec3 offset{0};
    int place = 0;            // what it adds to a place in a tile
    std::uint32_t sides = 0;  // of a tile: the way leads out of it from voxels at one of these
    std::ptrdiff_t index = 0; // what it adds to an index in the volume
};
// All ways, in a volume of these dimensions.
std::vector<Way> waysTo(Connectivity connectivity, glm::ivec3 dims);

// A set that spreads breadth first, on the host: while it is small voxel by voxel, as a plain queue, then by
// tiles of 8^3 voxels, eight words of bits at a time. Internal to this folder.
class HostSpread {
public:
    HostSpread(HostBricks& bricks, glm::ivec3 dims)
        : bricks_(&bricks), dims_(dims), acrossFaces_(waysTo(Connectivity::Six, dims)),
          allAround_(waysTo(Connectivity::TwentySix, dims)) {}

    // There are no newest voxels any more.
    void clear();
    // The bricks that the next expansion needs, some of them more than once.
    [[nodiscard]] std::vector<HostBrick*> front() const;
    // A voxel is among the newest, and no longer open.
    void add(glm::ivec3 voxel);
    // So are the given ones of a tile, which has no others.
    void add(const TileOfBrick& tile, const Slices& voxels, Connectivity connectivity);

    // What a spread is to do: so many expansions, but none after one that found nothing, nor once so many
    // voxels have joined.
    struct Order {
        Connectivity connectivity = Connectivity::Six;
        int generation = 1; // of the first expansion
        int expansions = 1;
        std::uint64_t mostVoxels = std::numeric_limits<std::uint64_t>::max();
    };
    // In an expansion everything open next to the newest voxels that the rules (HostRules, or what answers
    // as they do) let in joins, and they are the newest then. Adds to `joined` how many by each. `store` is
    // told of each: store(tile, place in it, generation), by several threads at once. When this throws, what
    // has joined so far is noted in the bricks.
    template <typename Rules, typename Store>
    void expand(const Rules& rules, const Order& order, const Store& store,
                std::vector<std::uint64_t>& joined) {
        Step<Rules, Store> step{rules, order.connectivity, store, std::uint32_t(order.generation)};
        std::uint64_t total = 0;
        bool goesOn = true;
        for (int i = 0; i < order.expansions && total < order.mostVoxels && goesOn; ++i) {
            chooseHow(order.connectivity);
            last_ = isByTile_ ? expandTiles(step) : expandQueue(step);
            joined.push_back(last_);
            total += last_;
            goesOn = last_ > 0;
            ++step.generation;
        }
    }

private:
    struct Queued {
        // Each member is stored by itself: read back as a pair from where it was put one by one, processors
        // wait.
        Queued(const TileOfBrick& tile, std::uint32_t inTile, std::size_t inVolume)
            : brick(tile.brick), tileOfBrick(tile.tile), place(inTile), index(inVolume) {}
        [[nodiscard]] TileOfBrick tile() const { return {brick, tileOfBrick}; }

        HostBrick* brick;
        std::uint32_t tileOfBrick;
        std::uint32_t place; // in the tile
        std::size_t index;   // in the volume
    };
    enum class Answer { Joins, Refused, RefusedFromHere };
    // What became of a tile.
    struct Found {
        std::uint32_t joined = 0;
        std::uint32_t touched = 0; // of the 27 tiles around it: in these the newest voxels have neighbours
    };
    template <typename Rules, typename Store>
    struct Step {
        const Rules& rules;
        Connectivity connectivity;
        const Store& told;
        std::uint32_t generation;

        void store(const TileOfBrick& tile, std::uint32_t place) const { told(tile, place, generation); }
    };

    // So many in a generation make tiles worth their while, so few do not.
    static constexpr std::uint64_t kMany = 256;
    static constexpr std::uint64_t kFew = 64;

    // Tiles that are looked at by several threads.
    static constexpr std::size_t kWorthACrew = 256;
    static constexpr std::size_t kTilesAtOnce = 64;

    Crew& crew();
    void chooseHow(Connectivity connectivity);
    void goOverToTiles(Connectivity connectivity);
    void goOverToQueue();
    void activate(const TileOfBrick& tile, std::uint32_t from);
    void activateAround(const TileOfBrick& tile, std::uint32_t touched);
    [[nodiscard]] const Slices& newestIn(const TileOfBrick& tile, std::uint32_t around,
                                         std::uint32_t n) const;
    [[nodiscard]] Slices offered(const TileOfBrick& tile, std::uint32_t around,
                                 Connectivity connectivity) const;
    [[nodiscard]] Slices offeredAcrossFaces(const TileOfBrick& tile, std::uint32_t around) const;
    [[nodiscard]] Slices offeredAllAround(const TileOfBrick& tile, std::uint32_t around) const;

    template <typename S>
    std::uint64_t expandTiles(const S& step);
    template <typename S>
    Found expandTile(const S& step, const TileOfBrick& tile);
    template <typename S>
    void test(const S& step, const TileOfBrick& tile, Slices& fresh);
    template <typename S>
    void testPairs(const S& step, const TileOfBrick& tile, std::uint32_t around, Slices& fresh) const;
    template <typename S>
    std::uint64_t expandQueue(const S& step);
    template <typename S, typename Ask>
    void expandQueueBy(const S& step, const Ask& ask);
    [[nodiscard]] std::size_t indexOf(glm::ivec3 voxel) const;
    [[nodiscard]] const std::vector<Way>& ways(Connectivity connectivity) const {
        return connectivity == Connectivity::Six ? acrossFaces_ : allAround_;
    }

    HostBricks* bricks_;
    glm::ivec3 dims_;
    std::vector<Way> acrossFaces_;
    std::vector<Way> allAround_;
    bool isByTile_ = false;
    std::uint32_t now_ = 0;           // which of a tile's newest voxels are read
    std::uint64_t last_ = 0;          // as many are the newest
    std::vector<TileOfBrick> tiles_;  // to be looked at by the next expansion
    std::vector<TileOfBrick> looked_; // by the last one
    std::vector<Found> found_;        // in those
    std::vector<Queued> queue_;
    std::vector<Queued> joining_;
    std::unique_ptr<Crew> crew_; // made when first needed
};

// The tiles around one, itself among them, in which some of these voxels have neighbours.
std::uint32_t tilesTouched(const Slices& voxels, Connectivity connectivity);

template <typename S>
std::uint64_t HostSpread::expandTiles(const S& step) {
    looked_.swap(tiles_);
    tiles_.clear();
    found_.resize(looked_.size());
    const auto expandSome = [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            found_[i] = expandTile(step, looked_[i]);
        }
    };
    if (looked_.size() < kWorthACrew) {
        expandSome(0, looked_.size());
    } else {
        crew().run(looked_.size(), kTilesAtOnce, expandSome);
    }
    now_ = 1 - now_;
    std::uint64_t joined = 0;
    for (std::size_t i = 0; i < looked_.size(); ++i) {
        if (found_[i].joined > 0) {
            joined += found_[i].joined;
            bricks_->noteJoined(*looked_[i].brick, int(step.generation));
        }
    }
    for (std::size_t i = 0; i < looked_.size(); ++i) {
        if (found_[i].joined > 0) {
            activateAround(looked_[i], found_[i].touched);
        }
    }
    return joined;
}

template <typename S>
HostSpread::Found HostSpread::expandTile(const S& step, const TileOfBrick& tile) {
    const std::uint32_t around = std::exchange(tile.around(), 0U);
    Slices fresh = offered(tile, around, step.connectivity);
    fresh &= tile->open;
    if (fresh.any() == 0) {
        return {};
    }
    if (!tile.isTested()) {
        test(step, tile, fresh);
    }
    if (step.rules.hasPairs()) {
        testPairs(step, tile, around, fresh);
    }
    if (fresh.any() == 0) {
        return {};
    }
    tile->newest[1 - now_] = fresh;
    tile->open -= fresh;
    tile->joined |= fresh;
    tile.brick->hasJoined[tile.tile] = 1;
    std::uint32_t count = 0;
    slices::forEach(fresh, [&](std::uint32_t place) {
        step.store(tile, place);
        ++count;
    });
    return {count, tilesTouched(fresh, step.connectivity)};
}

// Leaves of the fresh voxels those that the rules let in by themselves. A tile is tested whole as soon as
// they let some in; until then what they refuse is not asked about again.
template <typename S>
void HostSpread::test(const S& step, const TileOfBrick& tile, Slices& fresh) {
    const glm::ivec3 origin = tile.origin();
    bool letsIn = false;
    slices::forEach(fresh, [&](std::uint32_t place) {
        letsIn = letsIn || step.rules.admits(origin + slices::voxelAt(place));
    });
    if (letsIn) {
        tile->open &= step.rules.admitted(origin);
        tile.brick->isTested[tile.tile] = 1;
        fresh &= tile->open;
    } else {
        tile->open -= fresh;
        fresh = {};
    }
}

// Leaves those that one of the newest voxels around them may be left for.
template <typename S>
void HostSpread::testPairs(const S& step, const TileOfBrick& tile, std::uint32_t around,
                           Slices& fresh) const {
    const glm::ivec3 origin = tile.origin();
    const auto isNewest = [&](glm::ivec3 inTile) {
        const glm::ivec3 offset = inTile >> 3; // -1, 0 or 1
        const auto n = std::uint32_t(offset.x + 1 + 3 * (offset.y + 1) + 9 * (offset.z + 1));
        return (around >> n & 1U) != 0 &&
               slices::has(bricks_->near(tile, n)->newest[now_], slices::placeOf(inTile & 7));
    };
    slices::forEach(Slices(fresh), [&](std::uint32_t place) {
        const glm::ivec3 child = slices::voxelAt(place);
        bool isLetIn = false;
        for (const Way& way : ways(step.connectivity)) {
            isLetIn = isLetIn || (isNewest(child + way.offset) &&
                                  step.rules.admitsFrom(origin + child + way.offset, origin + child));
        }
        if (!isLetIn) {
            slices::clear(fresh, place);
        }
    });
}

template <typename S>
std::uint64_t HostSpread::expandQueue(const S& step) {
    joining_.clear();
    if (step.rules.asksOnlyForRange()) {
        expandQueueBy(step, [&](TileOfBrick tile, std::uint32_t, std::size_t index, const Way&) {
            return tile.isTested() || step.rules.isInRangeAt(index) ? Answer::Joins : Answer::Refused;
        });
    } else {
        expandQueueBy(step, [&](TileOfBrick tile, std::uint32_t place, std::size_t, const Way& way) {
            const glm::ivec3 voxel = tile.origin() + slices::voxelAt(place);
            if (!tile.isTested() && !step.rules.admits(voxel)) {
                return Answer::Refused;
            }
            return step.rules.admitsFrom(voxel - way.offset, voxel) ? Answer::Joins : Answer::RefusedFromHere;
        });
    }
    queue_.swap(joining_);
    return queue_.size();
}

template <typename S, typename Ask>
void HostSpread::expandQueueBy(const S& step, const Ask& ask) {
    const std::vector<Way>& waysOut = ways(step.connectivity);
    for (const Queued& parent : queue_) {
        const std::uint32_t sides = slices::kSidesAt[parent.place];
        for (const Way& way : waysOut) {
            TileOfBrick tile = parent.tile();
            std::uint32_t place = parent.place + std::uint32_t(way.place);
            if ((sides & way.sides) != 0) {
                const glm::ivec3 to = slices::voxelAt(parent.place) + way.offset;
                tile = bricks_->near(tile, to >> 3);
                place = slices::placeOf(to & 7);
            }
            if (!tile || !slices::has(tile->open, place)) {
                continue;
            }
            const std::size_t index = parent.index + std::size_t(way.index);
            const Answer answer = ask(tile, place, index, way);
            if (answer == Answer::Refused) {
                slices::clear(tile->open, place);
            } else if (answer == Answer::Joins) {
                joining_.emplace_back(tile, place, index);
                bricks_->join(tile, place, int(step.generation));
                step.store(tile, place);
            }
        }
    }
}

} // namespace vs::segment

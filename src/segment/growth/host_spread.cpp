// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/host_spread.h"

#include "base/parallel.h"

#include <bit>
#include <cstdlib>

namespace vs::segment {

namespace {

// Of the 27 tiles around one, those across its faces.
constexpr std::uint32_t kBeforeX = 12;
constexpr std::uint32_t kAfterX = 14;
constexpr std::uint32_t kBeforeY = 10;
constexpr std::uint32_t kAfterY = 16;
constexpr std::uint32_t kBeforeZ = 4;
constexpr std::uint32_t kAfterZ = 22;

constexpr bool has(std::uint32_t around, std::uint32_t n) { return (around >> n & 1U) != 0; }

} // namespace

std::vector<Way> waysTo(Connectivity connectivity, glm::ivec3 dims) {
    std::vector<Way> ways;
    for (std::uint32_t n = 0; n < 27; ++n) {
        const glm::ivec3 to = kOffsets[n];
        if (n != kItself && (connectivity == Connectivity::TwentySix ||
                             std::abs(to.x) + std::abs(to.y) + std::abs(to.z) == 1)) {
            ways.push_back({to, to.x + 8 * to.y + 64 * to.z,
                            slices::sidesOf(to.x<0, to.x> 0, to.y<0, to.y> 0, to.z<0, to.z> 0),
                            to.x + dims.x * (to.y + std::ptrdiff_t(dims.y) * to.z)});
        }
    }
    return ways;
}

std::uint32_t tilesTouched(const Slices& voxels, Connectivity connectivity) {
    const std::uint64_t all = voxels.any();
    const auto along = [](bool before, bool after) {
        return 2U | std::uint32_t(before) | std::uint32_t(after) << 2U;
    };
    const std::uint32_t x = along((all & slices::kColumn) != 0, (all & slices::kColumn << 7U) != 0);
    const std::uint32_t y = along((all & slices::kRow) != 0, (all & slices::kRow << 56U) != 0);
    const std::uint32_t z = along(voxels.z[0] != 0, voxels.z[7] != 0);
    if (connectivity == Connectivity::Six) {
        return x << 12U | (y & 1U) << kBeforeY | (y >> 2U) << kAfterY | (z & 1U) << kBeforeZ |
               (z >> 2U) << kAfterZ;
    }
    const std::uint32_t plane = (y & 1U) * x | x << 3U | (y >> 2U) * x << 6U;
    return (z & 1U) * plane | plane << 9U | (z >> 2U) * plane << 18U;
}

void HostSpread::clear() {
    tiles_.clear();
    looked_.clear();
    queue_.clear();
    isByTile_ = false;
    last_ = 0;
}

std::vector<HostBrick*> HostSpread::front() const {
    std::vector<HostBrick*> bricks;
    for (const Queued& voxel : queue_) {
        bricks.push_back(voxel.brick);
    }
    // The newest voxels lie in those that were looked at last, or were added since.
    for (const std::vector<TileOfBrick>* tiles : {&tiles_, &looked_}) {
        for (const TileOfBrick& tile : *tiles) {
            bricks.push_back(tile.brick);
        }
    }
    return bricks;
}

void HostSpread::add(glm::ivec3 voxel) {
    const TileOfBrick tile = bricks_->tileOf(voxel);
    const std::uint32_t place = slices::placeOf(voxel & 7);
    slices::clear(tile->open, place);
    queue_.emplace_back(tile, place, indexOf(voxel));
}

std::size_t HostSpread::indexOf(glm::ivec3 voxel) const {
    return (std::size_t(voxel.z) * std::size_t(dims_.y) + std::size_t(voxel.y)) * std::size_t(dims_.x) +
           std::size_t(voxel.x);
}

void HostSpread::add(const TileOfBrick& tile, const Slices& voxels, Connectivity connectivity) {
    isByTile_ = true;
    tile->newest[now_] = voxels;
    const std::uint32_t itself = tile->open.any() != 0 ? 0 : 1U << kItself;
    activateAround(tile, tilesTouched(voxels, connectivity) & ~itself);
    last_ += kMany; // whatever there is is spread by tiles first
}

Crew& HostSpread::crew() {
    if (!crew_) {
        crew_ = std::make_unique<Crew>(processorCount());
    }
    return *crew_;
}

void HostSpread::chooseHow(Connectivity connectivity) {
    if (isByTile_ && last_ < kFew) {
        goOverToQueue();
    }
    if (queue_.size() > kMany || (isByTile_ && !queue_.empty())) {
        goOverToTiles(connectivity);
    }
}

void HostSpread::goOverToTiles(Connectivity connectivity) {
    isByTile_ = true;
    for (const Queued& voxel : queue_) {
        const TileOfBrick tile = voxel.tile();
        if (!has(tile.around(), kItself)) {
            tile->newest[now_] = {};
            activate(tile, kItself);
        }
        slices::set(tile->newest[now_], voxel.place);
        Slices one;
        slices::set(one, voxel.place);
        activateAround(tile, tilesTouched(one, connectivity));
    }
    queue_.clear();
}

void HostSpread::goOverToQueue() {
    isByTile_ = false;
    for (std::size_t i = 0; i < looked_.size(); ++i) {
        const TileOfBrick& tile = looked_[i];
        if (found_[i].joined > 0) {
            slices::forEach(tile->newest[now_], [&](std::uint32_t place) {
                queue_.emplace_back(tile, place, indexOf(tile.origin() + slices::voxelAt(place)));
            });
        }
    }
    for (const TileOfBrick& tile : tiles_) {
        tile.around() = 0;
    }
    tiles_.clear();
}

void HostSpread::activate(const TileOfBrick& tile, std::uint32_t from) {
    if (tile.around() == 0) {
        tiles_.push_back(tile);
    }
    tile.around() |= 1U << from;
}

void HostSpread::activateAround(const TileOfBrick& tile, std::uint32_t touched) {
    for (; touched != 0; touched &= touched - 1) {
        const auto n = std::uint32_t(std::countr_zero(touched));
        // Its own newest voxels count as read by itself, even where it is full.
        const TileOfBrick near = n == kItself ? tile : bricks_->near(tile, n);
        if (near && (n == kItself || near->open.any() != 0)) {
            activate(near, 26 - n);
        }
    }
}

Slices HostSpread::offered(const TileOfBrick& tile, std::uint32_t around, Connectivity connectivity) const {
    return connectivity == Connectivity::Six ? offeredAcrossFaces(tile, around)
                                             : offeredAllAround(tile, around);
}

// The newest voxels of one of the 27 tiles around one, where they are to be spread from.
const Slices& HostSpread::newestIn(const TileOfBrick& tile, std::uint32_t around, std::uint32_t n) const {
    static constexpr Slices kNothing{};
    return !has(around, n) ? kNothing
           : n == kItself  ? tile->newest[now_]
                           : bricks_->near(tile, n)->newest[now_];
}

Slices HostSpread::offeredAcrossFaces(const TileOfBrick& tile, std::uint32_t around) const {
    const auto from = [&](std::uint32_t n) -> const Slices& { return newestIn(tile, around, n); };
    const Slices& own = from(kItself);
    Slices to;
    for (std::size_t z = 0; z < 8; ++z) {
        to.z[z] = slices::spreadX(own.z[z]) | slices::spreadY(own.z[z]);
    }
    for (std::size_t z = 0; z < 7; ++z) {
        to.z[z] |= own.z[z + 1];
        to.z[z + 1] |= own.z[z];
    }
    if (has(around, kBeforeX) || has(around, kAfterX)) {
        const Slices& before = from(kBeforeX);
        const Slices& after = from(kAfterX);
        for (std::size_t z = 0; z < 8; ++z) {
            to.z[z] |= slices::fromX(before.z[z], after.z[z]);
        }
    }
    if (has(around, kBeforeY) || has(around, kAfterY)) {
        const Slices& before = from(kBeforeY);
        const Slices& after = from(kAfterY);
        for (std::size_t z = 0; z < 8; ++z) {
            to.z[z] |= slices::fromY(before.z[z], after.z[z]);
        }
    }
    to.z[0] |= from(kBeforeZ).z[7];
    to.z[7] |= from(kAfterZ).z[0];
    return to;
}

Slices HostSpread::offeredAllAround(const TileOfBrick& tile, std::uint32_t around) const {
    std::array<const Slices*, 27> from{};
    for (std::uint32_t n = 0; n < 27; ++n) {
        from[n] = &newestIn(tile, around, n);
    }
    // Slices -1 to 8, each spread in its plane.
    std::array<std::uint64_t, 10> spread{};
    for (std::size_t i = 0; i < 10; ++i) {
        const std::size_t layer = i == 0 ? 0 : i == 9 ? 2 : 1;
        const std::size_t z = (i + 7) % 8;
        const auto row = [&](std::size_t y) { // of three tiles along x
            const std::size_t n = 9 * layer + 3 * y;
            return slices::spreadX(from[n + 1]->z[z]) | slices::fromX(from[n]->z[z], from[n + 2]->z[z]);
        };
        spread[i] = slices::spreadY(row(1)) | slices::fromY(row(0), row(2));
    }
    Slices to;
    for (std::size_t z = 0; z < 8; ++z) {
        to.z[z] = spread[z] | spread[z + 1] | spread[z + 2];
    }
    return to;
}

} // namespace vs::segment

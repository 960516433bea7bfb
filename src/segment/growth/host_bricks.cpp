// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/host_bricks.h"

#include "segment/growth/host_fence.h"

namespace vs::segment {

namespace {

// Calls f(tile, words) with each tile of a brick and its words in a plane.
template <typename Words, typename F>
void forEachTile(HostBrick& brick, Words* plane, F&& f) {
    Words* words = plane + brick.number * SeedMap::kWordsPerBrick;
    for (HostTile& tile : brick.tiles) {
        f(tile, words);
        words += SeedMap::kWordsPerTile;
    }
}

void close(HostBrick& brick, const std::uint32_t* plane) {
    forEachTile(brick, plane,
                [](HostTile& tile, const std::uint32_t* words) { tile.open -= slices::fromWords(words); });
}

} // namespace

HostBricks::HostBricks(glm::ivec3 dims)
    : brickDims_(divideUp(dims, field::kBrick)),
      bricks_(std::size_t(brickDims_.x) * std::size_t(brickDims_.y) * std::size_t(brickDims_.z)) {}

void HostBricks::keepOnly(const std::vector<HostBrick*>& needed) {
    std::vector<std::unique_ptr<HostBrick>> kept;
    kept.reserve(needed.size());
    for (HostBrick* brick : needed) {
        if (bricks_[brick->number] != nullptr) { // else it is listed twice
            kept.push_back(std::move(bricks_[brick->number]));
        }
    }
    for (std::unique_ptr<HostBrick>& brick : bricks_) {
        brick.reset();
    }
    made_ = kept.size();
    for (std::unique_ptr<HostBrick>& brick : kept) {
        bricks_[brick->number] = std::move(brick);
    }
}

void HostBricks::forget() {
    ++present_;
    for (HostBrick* brick : joined_) {
        brick->joinedIn = {};
    }
    joined_.clear();
}

HostBrick& HostBricks::brick(std::uint32_t number) {
    const glm::uvec3 dims(brickDims_);
    return brickAt(number,
                   {int(number % dims.x), int(number / dims.x % dims.y), int(number / (dims.x * dims.y))});
}

HostBrick& HostBricks::brickAt(std::uint32_t number, glm::ivec3 place) {
    std::unique_ptr<HostBrick>& brick = bricks_[number];
    if (!brick) {
        if (joined_.capacity() == made_) {
            joined_.reserve(2 * made_ + 16);
        }
        brick = std::make_unique<HostBrick>();
        brick->number = number;
        brick->place = place;
        ++made_;
    }
    if (brick->madeFor != present_) {
        brick->around.fill(0);
        brick->isTested.fill(0);
        brick->hasJoined.fill(0);
        brick->whenJoined.fill(nullptr);
        for (HostTile& tile : brick->tiles) {
            tile.joined = {};
        }
        brick->values = nullptr;
        open(*brick);
        brick->madeFor = present_;
    }
    return *brick;
}

TileOfBrick HostBricks::across(const HostBrick& from, const glm::ivec3& step, std::uint32_t tile) {
    const glm::ivec3 to = from.place + step;
    if (!glm::all(glm::lessThan(glm::uvec3(to), glm::uvec3(brickDims_)))) {
        return {};
    }
    return {&brickAt(std::uint32_t((to.z * brickDims_.y + to.y) * brickDims_.x + to.x), to), tile};
}

TileOfBrick HostBricks::tileOf(glm::ivec3 voxel) {
    const glm::ivec3 place = voxel / field::kBrick;
    const glm::ivec3 tile = (voxel & (field::kBrick - 1)) >> 3;
    return {&brickAt(std::uint32_t((place.z * brickDims_.y + place.y) * brickDims_.x + place.x), place),
            std::uint32_t(tile.x | tile.y << 2 | tile.z << 4)};
}

void HostBricks::writeJoined(HostBrick& brick, std::uint32_t* plane) noexcept {
    std::size_t tile = 0;
    forEachTile(brick, plane, [&](HostTile& t, std::uint32_t* words) {
        if (std::exchange(brick.hasJoined[tile++], std::uint8_t(0)) != 0) {
            slices::joinWords(t.joined, words);
            t.joined = {};
        }
    });
}

void BricksToGrowInto::open(HostBrick& brick) {
    const glm::ivec3 left = seedMap_->dims() - brick.place * field::kBrick;
    for (std::uint32_t tile = 0; tile < brick.tiles.size(); ++tile) {
        brick.tiles[tile].open =
            slices::box(glm::clamp(left - 8 * placeOfTile(tile), glm::ivec3(0), glm::ivec3(8)));
    }
    if (seedMap_->bricks().isOccupied(brick.number)) {
        close(brick, seedMap_->shared().grown);
    }
    if (rules_.forbidden != nullptr) {
        close(brick, reinterpret_cast<const std::uint32_t*>(rules_.forbidden->shared().data()));
    }
    if (rules_.constraints->hasFence()) {
        closeBehindFence(brick);
    }
}

void BricksToGrowInto::closeBehindFence(HostBrick& brick) const {
    const Box3 box = seedMap_->bricks().box(brick.number);
    const HostFence fence(*rules_.constraints, box);
    forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t) {
        if (!fence.letsIn(voxel)) {
            const glm::ivec3 tile = (voxel & (field::kBrick - 1)) >> 3;
            slices::clear(brick.tiles[std::size_t(tile.x | tile.y << 2 | tile.z << 4)].open,
                          slices::placeOf(voxel & 7));
        }
    });
}

void BricksOfRegion::open(HostBrick& brick) {
    forEachTile(brick, region_,
                [](HostTile& tile, const std::uint32_t* words) { tile.open = slices::fromWords(words); });
    brick.isTested.fill(1);
}

} // namespace vs::segment

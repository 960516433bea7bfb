// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/host_frontier.h"

#include "gl/pass.h"
#include "segment/growth/brick_texels.h"
#include "segment/growth/host_seeds.h"

#include <algorithm>
#include <utility>

namespace vs::segment {

namespace {

// Of a tile's grown voxels those of the segment at work; the labels are of the tile's brick.
Slices ownOf(const TileOfBrick& tile, Slices grown, const Owner& owner, const BrickTexels& labels) {
    slices::forEach(Slices(grown), [&](std::uint32_t place) {
        const auto label = std::to_integer<std::uint8_t>(*labels.at(tile.origin() + slices::voxelAt(place)));
        if (label != 0 && label != owner.label) {
            slices::clear(grown, place);
        }
    });
    return grown;
}

// Those of generations after `last`.
Slices laterThan(const TileOfBrick& tile, Slices grown, const SeedMap::Shared& map, std::uint32_t last) {
    slices::forEach(Slices(grown), [&](std::uint32_t place) {
        if (map.generationAt(tile.number() * slices::kVoxels + slices::numberOf(place)) <= last) {
            slices::clear(grown, place);
        }
    });
    return grown;
}

} // namespace

std::vector<Frontier::SeedAnswer> HostFrontier::testSeeds(SeedMap& seedMap, const Rules& rules, int playhead,
                                                          std::span<const std::uint32_t> voxels) {
    gl::Buffer::waitForDevice();
    std::vector<SeedAnswer> answers;
    answers.reserve(voxels.size());
    volume::visit(values_.get(), [&](const auto* values) {
        const HostRules byValue(values, *rules.field, *rules.constraints);
        HostSeeds seeds(seedMap, rules, playhead);
        for (const std::uint32_t voxel : voxels) {
            const glm::ivec3 at = seedMap.voxelAt(voxel);
            answers.push_back(seeds.answer(at, byValue.admits(at)));
        }
    });
    return answers;
}

void HostFrontier::invalidate() {
    isValid_ = false;
    added_.clear();
}

void HostFrontier::add(std::span<const std::uint32_t> voxels) {
    if (isValid_) { // else all grown voxels are collected anyway
        added_.insert(added_.end(), voxels.begin(), voxels.end());
    }
}

// All grown voxels of the segment at work, other than frozen ones, are the newest.
void HostFrontier::collect(const SeedMap& seedMap, const Rules& rules) {
    bricks_.forget();
    spread_.clear();
    const SeedMap::Shared map = seedMap.shared();
    for (const std::uint32_t number : seedMap.bricks().touched()) {
        HostBrick& brick = bricks_.brick(number);
        const BrickTexels labels = rules.owner.hasOthers
                                       ? BrickTexels(seedMap.labels(), seedMap.bricks().box(number))
                                       : BrickTexels();
        for (std::uint32_t t = 0; t < brick.tiles.size(); ++t) {
            const TileOfBrick tile{&brick, t};
            Slices grown = slices::fromWords(map.grown + tile.number() * SeedMap::kWordsPerTile);
            if (rules.owner.hasOthers) {
                grown = ownOf(tile, grown, rules.owner, labels);
            }
            if (rules.frozen > 0) {
                grown = laterThan(tile, grown, map, std::uint32_t(rules.frozen));
            }
            if (grown.any() != 0) {
                spread_.add(tile, grown, rules.constraints->connectivity);
            }
        }
    }
}

std::vector<std::uint64_t> HostFrontier::expand(SeedMap& seedMap, const Rules& rules, int generation,
                                                int expansions) {
    const gl::Pass pass("expand region");
    if (generation > SeedMap::kLongest16) {
        seedMap.widen();
    } else {
        expansions = std::min(expansions, SeedMap::kLongest16 + 1 - generation);
    }
    gl::Buffer::waitForDevice();
    bricks_.goBy(seedMap, rules);
    const bool wasValid = std::exchange(isValid_, false); // until all has gone well
    if (!wasValid) {
        collect(seedMap, rules);
    }
    for (const std::uint32_t voxel : added_) {
        spread_.add(seedMap.voxelAt(voxel));
    }
    added_.clear();

    std::vector<std::uint64_t> grown;
    grown.reserve(std::size_t(expansions));
    const SeedMap::Shared map = seedMap.shared();
    try {
        volume::visit(values_.get(), [&](const auto* values) {
            const HostRules hostRules(values, *rules.field, *rules.constraints);
            spread_.expand(
                hostRules, {rules.constraints->connectivity, generation, expansions, kManyVoxels},
                [&](const TileOfBrick& tile, std::uint32_t place, std::uint32_t joinedIn) {
                    map.setGeneration(tile.number() * slices::kVoxels + slices::numberOf(place), joinedIn);
                },
                grown);
        });
    } catch (...) {
        writeJoined(seedMap);
        throw;
    }
    writeJoined(seedMap);
    isValid_ = true;
    return grown;
}

void HostFrontier::writeJoined(SeedMap& seedMap) noexcept {
    BrickTable& bricks = seedMap.bricks();
    bricks_.writeJoined(seedMap.shared().grown, [&](std::uint32_t brick, GenerationSpan joined) {
        const GenerationSpan before = bricks.span(brick);
        bricks.setSpan(brick, {before.first == 0 ? joined.first : before.first, joined.last});
    });
    bricks.upload();
}

int HostFrontier::flood(const SeedMap& seedMap, const Rules& rules, std::span<const std::uint32_t> seeds,
                        const gl::TexelBuffer& region, const gl::Buffer& reached, int expansions) {
    const gl::Pass pass("flood region");
    invalidate();
    gl::Buffer::waitForDevice();
    BricksOfRegion bricks(seedMap, reinterpret_cast<const std::uint32_t*>(region.buffer().shared().data()));
    HostSpread spread(bricks, seedMap.dims());
    for (const std::uint32_t seed : seeds) {
        const glm::ivec3 voxel = seedMap.voxelAt(seed);
        const TileOfBrick tile = bricks.tileOf(voxel);
        const std::uint32_t place = slices::placeOf(voxel & 7);
        if (slices::has(tile->open, place)) {
            spread.add(voxel);
            bricks.join(tile, place, 1);
        }
    }
    std::vector<std::uint64_t> joined;
    volume::visit(values_.get(), [&](const auto* values) {
        const HostRules hostRules(values, *rules.field, *rules.constraints);
        spread.expand(
            hostRules, {rules.constraints->connectivity, 1, expansions},
            [](const TileOfBrick&, std::uint32_t, std::uint32_t) {}, joined);
    });
    bricks.writeJoined(reinterpret_cast<std::uint32_t*>(reached.shared().data()),
                       [](std::uint32_t, GenerationSpan) {});
    return int(std::ranges::count_if(joined, [](std::uint64_t voxels) { return voxels > 0; }));
}

} // namespace vs::segment

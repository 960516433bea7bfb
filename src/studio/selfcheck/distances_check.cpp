// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "render/space/macrocells.h"

namespace vs::studio {

namespace {

// Ranges of cells of which only those that are marked reach into the displayed range.
gl::Texture cellsFrom(glm::ivec3 size, const std::vector<bool>& isMarked) {
    std::vector<glm::vec2> ranges;
    for (const bool marked : isMarked) {
        ranges.emplace_back(marked ? glm::vec2(0.2F, 0.9F) : glm::vec2(0.1F, 0.2F));
    }
    gl::Texture cells(size, gl::Format::RG32F, gl::Filter::Nearest, "self check cells");
    cells.upload({glm::ivec3(0), size}, std::as_bytes(std::span(ranges)));
    return cells;
}

// The distance of each cell from the nearest one that is marked, by looking at every pair.
std::vector<std::uint32_t> byEveryPair(glm::ivec3 size, const std::vector<bool>& isMarked) {
    std::vector<std::uint32_t> distances(isMarked.size(), render::Macrocells::kFar);
    const Box3 all{glm::ivec3(0), size};
    forEachVoxel(all, [&](glm::ivec3 from, std::size_t n) {
        if (!isMarked[n]) {
            return;
        }
        forEachVoxel(all, [&](glm::ivec3 to, std::size_t m) {
            const glm::ivec3 apart = glm::abs(from - to);
            const auto steps = std::uint32_t(std::max({apart.x, apart.y, apart.z}));
            distances[m] = std::min(distances[m], steps);
        });
    });
    return distances;
}

} // namespace

void checkDistances(Tally& tally) {
    std::mt19937 random(7);
    tally.about("distances, cells");
    // Sizes around those of the blocks of bits, and longer than any distance counts.
    for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(33, 5, 7), glm::ivec3(70, 30, 3)}) {
        for (const std::uint32_t oneIn : {2000U, 50U}) {
            std::vector<bool> isMarked(Box3{glm::ivec3(0), size}.volume());
            for (std::size_t n = 0; n < isMarked.size(); ++n) {
                isMarked[n] = random() % oneIn == 0;
            }
            const gl::Texture cells = cellsFrom(size, isMarked);
            render::Macrocells macrocells;
            macrocells.rebuild({.dataCells = &cells, .visibleRange = {0.5, 1.0}});
            const auto found = macrocells.distances().downloadAll<std::uint32_t>();
            const auto expected = byEveryPair(size, isMarked);
            tally.compareAll(std::span<const std::uint32_t>(found), std::span<const std::uint32_t>(expected));
        }
    }
}

} // namespace vs::studio

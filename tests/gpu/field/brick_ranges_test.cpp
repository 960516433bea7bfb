// SPDX-License-Identifier: Apache-2.0
#include "base/math.h"
#include "field/bricks/brick_ranges.h"
#include "property.h"

#include <bit>
#include <random>

namespace vs::field {
namespace {

glm::vec2 rangeOf(std::uint32_t word) {
    return {std::bit_cast<float>(word << 16), std::bit_cast<float>(word & 0xffff0000U)};
}

TEST(BrickRanges, WordsAreNoNarrowerThanTheRangeAndHardlyWider) {
    test::checkProperty(500, [] {
        const double lo = *test::between(-70000, 70000);
        const double hi = lo + *test::between(0, 3000);
        const glm::vec2 said = rangeOf(rangeWord(float(lo), float(hi)));
        RC_ASSERT((said.x <= float(lo) && said.y >= float(hi)));
        RC_ASSERT((float(lo) - said.x <= std::abs(float(lo)) / 128));
        RC_ASSERT((said.y - float(hi) <= std::abs(float(hi)) / 128));
    });
    for (const float exact : {0.0F, -1.0F, 150.0F, 255.0F, -1024.0F}) {
        EXPECT_EQ(rangeOf(rangeWord(exact, exact)), glm::vec2(exact));
    }
    const glm::vec2 any = rangeOf(kAnyValue);
    EXPECT_TRUE(any.x < -1e38F && any.y > 1e38F && std::isfinite(any.x) && std::isfinite(any.y));
}

// Of each cell those between which its samples are interpolated, and no more.
template <typename T>
void checkCells(const BrickTexels& meaning, float scale) {
    test::checkProperty(20, [&] {
        const int side = 1 + *test::below(30);
        const int seed = *test::below(1000);
        std::mt19937 random{unsigned(seed)};
        const Box3 box{glm::ivec3(0), glm::ivec3(side + 1)};
        std::vector<T> texels(box.volume());
        for (T& texel : texels) {
            texel = T(random() % 250); // whole numbers that words have exactly
        }
        const BrickRanges ranges = rangesOf(std::as_bytes(std::span(texels)), side, meaning);
        const int along = cellsAlong(side);
        RC_ASSERT(ranges.cells.size() == std::size_t(along) * std::size_t(along) * std::size_t(along));
        glm::vec2 all(1e9F, -1e9F);
        forEachVoxel({glm::ivec3(0), glm::ivec3(along)}, [&](glm::ivec3 cell, std::size_t n) {
            glm::vec2 range(1e9F, -1e9F);
            const Box3 own{cell * kBrickCell, (cell + 1) * kBrickCell + 1};
            forEachVoxel(box, [&](glm::ivec3 v, std::size_t at) {
                if (glm::all(glm::greaterThanEqual(v, own.lo)) && glm::all(glm::lessThan(v, own.hi))) {
                    const float value = float(texels[at]) * scale + meaning.valueOffset;
                    range = {std::min(range.x, value), std::max(range.y, value)};
                }
            });
            RC_ASSERT(rangeOf(ranges.cells[n]) == range);
            all = {std::min(all.x, range.x), std::max(all.y, range.y)};
        });
        RC_ASSERT(rangeOf(ranges.all) == all);
    });
}

TEST(BrickRanges, CellsHoldWhatTheirSamplesAreBetween) {
    checkCells<std::uint8_t>(brickTexels(volume::ScalarType::UInt8), 1);
    checkCells<std::uint16_t>(brickTexels(volume::ScalarType::UInt16), 1);
    checkCells<float>(brickTexels(volume::ScalarType::Float32), 1);
}

} // namespace
} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
// Where tiles of segments alone lie: each has a place of its own, and too many are refused.
#include "segment/membership/apart_tiles.h"

#include "base/error.h"
#include "field/shaders/apart_tiles.h"
#include "gpu/gl_test.h"

#include <numeric>
#include <set>

namespace vs::segment {
namespace {

using ApartTilesTest = test::GlTest;

std::vector<std::uint32_t> allTiles(glm::ivec3 dims) {
    std::vector<std::uint32_t> tiles(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
    std::iota(tiles.begin(), tiles.end(), 0U);
    return tiles;
}

std::vector<std::uint8_t> labelsUpTo(int last) {
    std::vector<std::uint8_t> labels(std::size_t(last), 0);
    std::iota(labels.begin(), labels.end(), std::uint8_t(1));
    return labels;
}

// A coarse atlas of 61 x 73 x 61 voxels, in which all of 255 regions touch one another everywhere.
TEST_F(ApartTilesTest, EachTileOfEachSegmentHasAPlaceOfItsOwn) {
    const glm::ivec3 dims(4, 5, 4);
    const auto tiles = allTiles(dims);
    const auto labels = labelsUpTo(255);
    ApartTiles apart(dims);
    apart.keep(labels);
    const std::vector<ApartTiles::Whose> beside(tiles.size(), ApartTiles::Whose::BesideOthers);
    std::set<std::uint32_t> places;
    for (const std::uint8_t label : labels) {
        for (const std::uint32_t page : apart.place(label, tiles, beside).pagesOfOwn) {
            places.insert(page & ~std::uint32_t(field::kPageWhose));
        }
    }
    EXPECT_EQ(places.size(), labels.size() * tiles.size());
    EXPECT_LE(apart.texels().size().z, 2048) << "what every device has room for";
}

TEST_F(ApartTilesTest, WhatIsPutBackLeavesItsPlaces) {
    const glm::ivec3 dims(3, 3, 3);
    const auto tiles = allTiles(dims);
    ApartTiles apart(dims);
    const std::vector<ApartTiles::Whose> beside(tiles.size(), ApartTiles::Whose::BesideOthers);
    std::size_t bytes = 0;
    for (int round = 0; round < 200; ++round) {
        const std::uint8_t label(std::uint8_t(1 + round));
        apart.keep(std::vector<std::uint8_t>{label});
        apart.place(label, tiles, beside);
        bytes = round == 0 ? apart.deviceBytes() : bytes;
    }
    EXPECT_EQ(apart.deviceBytes(), bytes);
}

TEST_F(ApartTilesTest, MoreThanThereArePlacesForIsRefused) {
    const glm::ivec3 dims(6, 6, 6);
    const auto tiles = allTiles(dims);
    const auto labels = labelsUpTo(255);
    ApartTiles apart(dims);
    apart.keep(labels);
    const std::vector<ApartTiles::Whose> beside(tiles.size(), ApartTiles::Whose::BesideOthers);
    const auto placeAll = [&] {
        for (const std::uint8_t label : labels) {
            apart.place(label, tiles, beside);
        }
    };
    EXPECT_THROW(placeAll(), Error);
}

} // namespace
} // namespace vs::segment

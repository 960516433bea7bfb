// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/smoothing.h"

#include "base/error.h"
#include "segment/edits/set_algebra.h"
#include "test_sets.h"

#include <gtest/gtest.h>

#include <limits>

namespace vs::segment {
namespace {

double volumeMm3(const VoxelSet& set, const volume::GridGeometry& grid) {
    return double(set.count()) * grid.voxelMm3();
}

TEST(Smooth, BallsKeepTheirVolume) {
    const volume::GridGeometry grids[] = {volume::makeGeometry({60, 60, 60}),
                                          volume::makeGeometry({60, 60, 20}, {1, 1, 3}),
                                          volume::makeGeometry({60, 40, 50}, {0.9, 1.3, 1.1})};
    for (const auto& grid : grids) {
        for (const double radius : {10.0, 15.0, 20.0}) {
            const VoxelSet set = ball(grid, glm::dvec3(grid.dims) / 2.0, radius);
            for (const double mm : {0.5, 1.0, 2.0}) {
                // What is left of the loss at curved surfaces goes with the fourth power of mm / radius.
                const double tolerance = radius >= 10 * mm ? 0.02 : 0.075;
                const double ratio = volumeMm3(smooth(set, grid, mm), grid) / volumeMm3(set, grid);
                EXPECT_NEAR(ratio, 1, tolerance) << radius << " mm, smoothed by " << mm << " mm";
            }
        }
    }
}

TEST(Smooth, SpikesAndPitsGo) {
    const auto grid = volume::makeGeometry({40, 40, 40});
    const VoxelSet block = boxSet({{8, 8, 8}, {32, 32, 32}});
    VoxelSet set = unite(block, boxSet({{20, 20, 32}, {21, 21, 33}}));
    set = unite(set, boxSet({{16, 20, 32}, {17, 21, 37}}));    // a hair
    set = subtract(set, boxSet({{24, 24, 31}, {25, 25, 32}})); // a pit
    set = subtract(set, boxSet({{24, 20, 27}, {25, 21, 32}})); // a shaft
    set = unite(set, boxSet({{2, 2, 2}, {3, 3, 3}}));          // a speck
    const VoxelSet smoothed = smooth(set, grid, 1);
    // Away from the block's edges, which become round, everything is flat again.
    const Box3 middle{{12, 12, 12}, {28, 28, 40}};
    EXPECT_EQ(smoothed.within(middle), block.within(middle));
    EXPECT_FALSE(smoothed.contains({2, 2, 2}));
}

TEST(Smooth, SheetsThinnerThanAskedGoAndThickerStay) {
    const auto grid = volume::makeGeometry({40, 40, 40}, {0.5, 0.5, 0.5});
    EXPECT_EQ(smooth(boxSet({{0, 0, 18}, {40, 40, 20}}), grid, 1.5), VoxelSet{});
    const VoxelSet thick = boxSet({{0, 0, 18}, {40, 40, 23}});
    EXPECT_EQ(smooth(thick, grid, 1.5), thick);
}

TEST(Smooth, WhatReachesTheGridsBorderGoesOnBeyondIt) {
    const auto grid = volume::makeGeometry({20, 20, 20});
    const VoxelSet all = boxSet(grid.box());
    EXPECT_EQ(smooth(all, grid, 3), all);
    const VoxelSet half = boxSet({{0, 0, 0}, {20, 20, 10}});
    EXPECT_EQ(smooth(half, grid, 3), half);
}

TEST(Smooth, TheOutsideIsTreatedAsTheInside) {
    const auto grid = volume::makeGeometry({24, 24, 24}, {1, 1, 1.7});
    const VoxelSet set = intersect(randomSet(grid.box(), 0.55, 11), boxSet({{6, 6, 6}, {18, 18, 18}}));
    // Blurring is symmetric; only values within rounding of 0.5 could tell, and a random set has none.
    EXPECT_EQ(smooth(complementIn(grid.box(), set), grid, 1), complementIn(grid.box(), smooth(set, grid, 1)));
}

TEST(Smooth, NothingOrTooLittleToSmooth) {
    const auto grid = volume::makeGeometry({12, 12, 2});
    EXPECT_EQ(smooth({}, grid, 1), VoxelSet{});
    EXPECT_EQ(smooth(emptySet(grid.box()), grid, 1), VoxelSet{});
    const VoxelSet set = randomSet(grid.box(), 0.5, 4);
    EXPECT_EQ(smooth(set, grid, 0), set);
    EXPECT_EQ(smooth(set, grid, 0.1), set);
    EXPECT_EQ(smooth(boxSet({{5, 5, 0}, {6, 6, 1}}), volume::makeGeometry({12, 12, 12}), 1), VoxelSet{});
    for (const double mm : {-1.0, 101.0, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(smooth(set, grid, mm), Error);
    }
}

} // namespace
} // namespace vs::segment

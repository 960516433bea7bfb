// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/margins.h"

#include "base/error.h"
#include "segment/edits/set_algebra.h"
#include "test_sets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

namespace vs::segment {
namespace {

volume::GridGeometry sheared() {
    auto geometry = volume::makeGeometry({20, 18, 16}, {1, 0.8, 1.5});
    geometry.worldFromVoxel[1] += 0.3 * geometry.worldFromVoxel[0];
    geometry.worldFromVoxel[2] += 0.5 * geometry.worldFromVoxel[1] - 0.4 * geometry.worldFromVoxel[0];
    return geometry;
}

volume::GridGeometry turned() {
    auto geometry = volume::makeGeometry({20, 18, 16}, {0.957, 0.957, 1.5});
    const double c = std::cos(0.3);
    const double s = std::sin(0.3);
    const glm::dmat4 turn(c, s, 0, 0, 0, 0, -1, 0, -s, c, 0, 0, 7, -3, 12, 1);
    geometry.worldFromVoxel = turn * geometry.worldFromVoxel;
    return geometry;
}

struct NamedGrid {
    const char* name;
    volume::GridGeometry geometry;

    friend std::ostream& operator<<(std::ostream& out, const NamedGrid& grid) { return out << grid.name; }
};

class Margins : public testing::TestWithParam<NamedGrid> {
protected:
    static const volume::GridGeometry& grid() { return GetParam().geometry; }
    Box3 wide() const { return grow(grid().box(), 8); } // holds whatever these tests grow
    VoxelSet blobs() const { // two balls, a bar at the grid's border and a few single voxels
        const VoxelSet balls = unite(ball(grid(), {6, 7, 6}, 4.2), ball(grid(), {13, 9, 8}, 3.1));
        return unite(unite(balls, boxSet({{15, 0, 0}, {20, 4, 3}})), randomSet(grid().box(), 0.002, 3));
    }
    // The set of all voxels of `box` at most `mm` from one of the set: every offset that short, from every
    // voxel.
    VoxelSet grownPlainly(const VoxelSet& set, double mm, const Box3& box) const {
        std::vector<glm::ivec3> offsets;
        forEachPlace({glm::ivec3(-9), glm::ivec3(10)}, [&](glm::ivec3 offset) {
            if (distanceMm(grid(), offset, {0, 0, 0}) <= mm * (1 + 1e-7)) {
                offsets.push_back(offset);
            }
        });
        VoxelSet result = set.within(box);
        forEachPlace(set.box, [&](glm::ivec3 voxel) {
            for (std::size_t i = 0; i < offsets.size() && set.contains(voxel); ++i) {
                const glm::ivec3 reached = voxel + offsets[i];
                if (glm::all(glm::greaterThanEqual(reached, box.lo)) &&
                    glm::all(glm::lessThan(reached, box.hi))) {
                    result.inside[result.indexOf(reached)] = 1;
                }
            }
        });
        return result;
    }
};

INSTANTIATE_TEST_SUITE_P(Grids, Margins,
                         testing::Values(NamedGrid{"even", volume::makeGeometry({20, 18, 16})},
                                         NamedGrid{"thick", volume::makeGeometry({20, 18, 16}, {1, 1, 3})},
                                         NamedGrid{"turned", turned()}, NamedGrid{"sheared", sheared()}));

// Distances at which many voxels lie exactly (1, 3, 2.871 = 3 x 0.957) and others.
constexpr double kDistances[] = {0, 0.5, 1, 2.3, 2.871, 3, 4.4};

TEST_P(Margins, OneVoxelGrowsToABall) {
    const glm::ivec3 centre(9, 8, 7);
    for (const double mm : kDistances) {
        EXPECT_EQ(changeMargin(boxSet({centre, centre + 1}), grid(), mm), ball(grid(), centre, mm))
            << mm << " mm";
    }
}

TEST_P(Margins, GrowsByExactlyTheDistance) {
    for (const double mm : kDistances) {
        EXPECT_EQ(changeMargin(blobs(), grid(), mm), grownPlainly(blobs(), mm, grid().box())) << mm << " mm";
    }
}

TEST_P(Margins, ShrinkingIsGrowthOfTheOutside) {
    for (const double mm : kDistances) {
        const VoxelSet outside = grownPlainly(complementIn(wide(), blobs()), mm, wide());
        EXPECT_EQ(changeMargin(blobs(), grid(), -mm), mm > 0 ? complementIn(wide(), outside) : blobs())
            << mm << " mm";
    }
}

TEST_P(Margins, OpeningAndClosingSettleAtOnce) {
    for (const double mm : {1.0, 1.7, 3.0}) {
        const VoxelSet opened = opening(blobs(), grid(), mm);
        EXPECT_TRUE(isSubset(opened, blobs()));
        EXPECT_EQ(opening(opened, grid(), mm), opened) << mm << " mm";
        const VoxelSet closed = closing(blobs(), grid(), mm);
        EXPECT_TRUE(isSubset(blobs(), closed));
        EXPECT_TRUE(isSubset(closed, boxSet(grid().box())));
        EXPECT_EQ(closing(closed, grid(), mm), closed) << mm << " mm";
    }
}

TEST_P(Margins, WallsAreAsThickAsAsked) {
    const VoxelSet set = ball(grid(), {9, 8, 7}, 5);
    const VoxelSet outside = complementIn(wide(), set);
    for (const double mm : {1.0, 2.5}) {
        const VoxelSet nearOutside = grownPlainly(outside, mm, wide());
        EXPECT_EQ(hollow(set, grid(), mm, Wall::Inside), intersect(set, nearOutside));
        const VoxelSet nearSet = grownPlainly(set, mm, grid().box());
        EXPECT_EQ(hollow(set, grid(), mm, Wall::Outside), subtract(nearSet, set));
        EXPECT_EQ(hollow(set, grid(), mm, Wall::Centred),
                  intersect(grownPlainly(set, mm / 2, grid().box()), grownPlainly(outside, mm / 2, wide())));
    }
}

TEST(Margin, AtTheGridsBorderOutsideIsOutside) {
    const auto grid = volume::makeGeometry({10, 10, 10});
    const VoxelSet all = boxSet(grid.box());
    EXPECT_EQ(changeMargin(all, grid, 3), all);
    EXPECT_EQ(changeMargin(all, grid, -2), boxSet({{2, 2, 2}, {8, 8, 8}}));
    EXPECT_EQ(closing(all, grid, 2), all);
    EXPECT_EQ(changeMargin(all, grid, -5), VoxelSet{});
}

TEST(Margin, EmptySetsStayEmpty) {
    const auto grid = volume::makeGeometry({10, 10, 10});
    for (const VoxelSet& set : {VoxelSet{}, emptySet(grid.box())}) {
        EXPECT_EQ(changeMargin(set, grid, 3), VoxelSet{});
        EXPECT_EQ(changeMargin(set, grid, -3), VoxelSet{});
        EXPECT_EQ(opening(set, grid, 2), VoxelSet{});
        EXPECT_EQ(closing(set, grid, 2), VoxelSet{});
        EXPECT_EQ(hollow(set, grid, 2, Wall::Centred), VoxelSet{});
    }
}

TEST(Margin, SingleSlicesGrowWithinTheirGrid) {
    const auto grid = volume::makeGeometry({12, 12, 1}, {1, 1, 5});
    EXPECT_EQ(changeMargin(boxSet({{5, 5, 0}, {6, 6, 1}}), grid, 6), ball(grid, {5, 5, 0}, 6));
    EXPECT_EQ(changeMargin(boxSet(grid.box()), grid, -4), boxSet({{4, 4, 0}, {8, 8, 1}}));
}

TEST(Margin, ReachesFarBeyondSmallShearedGrids) {
    auto grid = volume::makeGeometry({10, 6, 6}, {0.1, 0.1, 10});
    grid.worldFromVoxel[2] += 50.0 * grid.worldFromVoxel[0];
    const VoxelSet voxel = boxSet({{3, 2, 1}, {4, 3, 2}});
    for (const double mm : {0.25, 11.2, 30.0, 60.0}) {
        EXPECT_EQ(changeMargin(voxel, grid, mm), ball(grid, {3, 2, 1}, mm)) << mm << " mm";
    }
    EXPECT_EQ(changeMargin(boxSet(grid.box()), grid, -0.25), boxSet({{2, 2, 0}, {8, 4, 6}}));
}

TEST(Margin, DistancesThatMakeNoSenseAreRefused) {
    const auto grid = volume::makeGeometry({10, 10, 10});
    const VoxelSet set = boxSet({{2, 2, 2}, {8, 8, 8}});
    for (const double mm : {std::numeric_limits<double>::quiet_NaN(), 1e9, -1e9}) {
        EXPECT_THROW(changeMargin(set, grid, mm), Error);
    }
    EXPECT_THROW(opening(set, grid, -1), Error);
    EXPECT_THROW(closing(set, grid, -1), Error);
    try {
        hollow(set, grid, -1);
        FAIL() << "accepted a negative thickness";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "a distance of -1 mm cannot be used here; it must lie between 0 and 17 mm, the "
                     "volume's diagonal");
    }
}

} // namespace
} // namespace vs::segment

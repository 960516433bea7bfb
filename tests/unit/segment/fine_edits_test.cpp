// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "segment/edits/fine_islands.h"
#include "segment/edits/fine_shapes.h"
#include "segment/edits/islands.h"
#include "segment/edits/margins.h"
#include "segment/edits/set_algebra.h"
#include "segment/edits/smoothing.h"
#include "segment/membership/membership.h"
#include "segment/membership/set_membership.h"
#include "test_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace vs::segment {
namespace {

// Pieces are 128 voxels along each axis where little is looked at around them: there are two along x, and
// bricks that the grid cuts short.
const volume::GridGeometry kLongGrid = volume::makeGeometry({150, 37, 34}, {1, 2, 1.5});

FineSet fineOf(const VoxelSet& set, glm::ivec3 dims = kLongGrid.dims) {
    FineSet fine(dims);
    fine.add(set.box, set.box, set.inside);
    return fine;
}

bool areSame(const FineSet& fine, const VoxelSet& set, const Box3& box = kLongGrid.box()) {
    return fine.within(box) == set.within(box).inside && fine.count() == set.count();
}

// Balls, a wall and a tube with noise, about where pieces meet and at the grid's border.
VoxelSet anyShapes() {
    const unsigned seed = unsigned(*test::below(1 << 20));
    std::mt19937 random(seed);
    std::vector<glm::vec4> balls;
    for (int n = 0; n < 6; ++n) {
        balls.emplace_back(float(random() % 150U), float(random() % 37U), float(random() % 34U),
                           2.0F + float(random() % 9U));
    }
    const int wall = int(100U + random() % 50U);
    const VoxelSet noise = randomSet(kLongGrid.box(), 0.02, seed);
    return setWhere(kLongGrid.box(), [&](glm::ivec3 v) {
        const bool isInBall = std::any_of(balls.begin(), balls.end(), [&](const glm::vec4& ball) {
            const float apart = glm::length(glm::vec3(v) - glm::vec3(ball));
            return apart < ball.w && apart > 0.3F * ball.w; // hollow
        });
        return isInBall != noise.contains(v) || (std::abs(v.x - wall) < 2 && v.y > 20);
    });
}

// A set with its axes going round, so that pieces meet along others.
glm::ivec3 turned(glm::ivec3 v, int turns) { return turns == 0 ? v : turned({v.z, v.x, v.y}, turns - 1); }
VoxelSet turned(const VoxelSet& set, int turns) {
    return setWhere({turned(set.box.lo, turns), turned(set.box.hi, turns)},
                    [&](glm::ivec3 v) { return set.contains(turned(v, (3 - turns) % 3)); });
}

TEST(FineSets, AreTheVoxelsThatTheyWereMadeOf) {
    test::checkProperty(20, [] {
        const VoxelSet a = *anySet({{90, 3, 2}, {140, 37, 34}}, 4000);
        const VoxelSet b = *anySet({{60, 0, 20}, {150, 30, 33}}, 4000);
        const FineSet fineA = fineOf(a);
        const FineSet fineB = fineOf(b);
        RC_ASSERT(areSame(fineA, a));
        RC_ASSERT(areSame(unite(fineA, fineB), unite(a, b)));
        RC_ASSERT(areSame(subtract(fineA, fineB), subtract(a, b)));
        RC_ASSERT(areSame(intersect(fineA, fineB), intersect(a, b)));
        const Box3 beyond{{80, -5, 10}, {170, 20, 50}};
        RC_ASSERT(fineA.within(beyond) == a.within(beyond).inside);
        FineSet byRows(kLongGrid.dims);
        fineA.forEachRow([&](int begin, int end, int y, int z) { byRows.addRow(begin, end, y, z); });
        RC_ASSERT(byRows == fineA);
        FineSet part(kLongGrid.dims);
        const Box3 half = intersect(a.box, Box3{{100, 0, 0}, {131, 37, 34}});
        part.add(half, a.box, a.inside);
        RC_ASSERT(areSame(part, a.within(half)));
    });
}

TEST(FineEdits, ShapesAreThoseOfAllOfTheGrid) {
    test::checkProperty(12, [] {
        const int turns = *test::below(3);
        const VoxelSet set = turned(anyShapes(), turns);
        volume::GridGeometry grid = volume::makeGeometry(turned(kLongGrid.dims, turns), {1, 2, 1.5});
        grid.worldFromVoxel[1][0] = *test::below(2) == 0 ? 0 : 0.7; // sheared
        const Box3 box = grid.box();
        const FineSet fine = fineOf(set, grid.dims);
        const double mm = 0.5 + *test::below(40) / 10.0;
        RC_ASSERT(areSame(changeMargin(fine, grid, mm), changeMargin(set, grid, mm), box));
        RC_ASSERT(areSame(changeMargin(fine, grid, -mm), changeMargin(set, grid, -mm), box));
        RC_ASSERT(areSame(opening(fine, grid, mm), opening(set, grid, mm), box));
        RC_ASSERT(areSame(closing(fine, grid, mm), closing(set, grid, mm), box));
        RC_ASSERT(areSame(hollow(fine, grid, mm), hollow(set, grid, mm), box));
        RC_ASSERT(areSame(smooth(fine, grid, mm), smooth(set, grid, mm), box));
    });
}

TEST(FineEdits, WhatNeedsTooManyVoxelsAroundEachIsRefused) {
    const volume::GridGeometry large = volume::makeGeometry({4000, 4000, 4000}, {0.1, 0.1, 0.1});
    FineSet ball(large.dims);
    ball.addRow(2000, 2040, 2000, 2000);
    EXPECT_THROW((void)changeMargin(ball, large, 20), Error);
    EXPECT_THROW((void)changeMargin(ball, large, std::nan("")), Error);
    EXPECT_THROW((void)smooth(ball, large, -1), Error);
    // And what is near enough takes what is there, not the grid: a row of 40 voxels grown by 40 each way.
    const std::uint64_t grown = changeMargin(ball, large, 4).count();
    const double capsule = 40.0 * 40 * (39 + 4.0 / 3 * 40) * std::acos(-1.0);
    EXPECT_NEAR(double(grown), capsule, 0.01 * capsule);
}

TEST(FineEdits, IslandsAndHolesAreThoseOfAllOfTheGrid) {
    test::checkProperty(6, [] {
        const VoxelSet set = anyShapes();
        const FineSet fine = fineOf(set);
        for (const Connectivity neighbours : {Connectivity::Six, Connectivity::TwentySix}) {
            RC_ASSERT(areSame(keepLargestIsland(fine, neighbours), keepLargestIsland(set, neighbours)));
            const double ml = *test::below(300) / 1000.0;
            RC_ASSERT(areSame(dropSmallIslands(fine, kLongGrid, ml, neighbours),
                              dropSmallIslands(set, kLongGrid, ml, neighbours)));
            const double inf = std::numeric_limits<double>::infinity();
            RC_ASSERT(areSame(fillHoles(fine, kLongGrid, inf, neighbours),
                              fillHoles(set, kLongGrid, inf, neighbours)));
            RC_ASSERT(areSame(fillHoles(fine, kLongGrid, ml, neighbours),
                              fillHoles(set, kLongGrid, ml, neighbours)));
            const std::vector<Island> all = islands(set, neighbours);
            const glm::ivec3 chosen = all[std::size_t(*test::below(int(all.size())))].first;
            const glm::ivec3 reach(kIslandReach);
            RC_ASSERT(
                areSame(keepIsland(fine, chosen, neighbours, reach), keepIsland(set, chosen, neighbours)));
            RC_ASSERT(
                areSame(dropIsland(fine, chosen, neighbours, reach), dropIsland(set, chosen, neighbours)));
        }
    });
}

TEST(FineEdits, NoIslandIsNearAnEmptyPlace) {
    const FineSet none(kLongGrid.dims);
    EXPECT_THROW((void)keepIsland(none, {4, 4, 4}, Connectivity::Six, glm::ivec3(3)), Error);
    EXPECT_TRUE(keepLargestIsland(none, Connectivity::Six).isEmpty());
    EXPECT_TRUE(fillHoles(none, kLongGrid).isEmpty());
    EXPECT_TRUE(smooth(none, kLongGrid, 2).isEmpty());
}

// Of boxes that begin anywhere, and reach beyond the grid.
TEST(FineSets, HaveTheMembershipOfASegment) {
    test::checkProperty(8, [] {
        const VoxelSet set = anyShapes();
        const std::vector<std::uint8_t> labels = set.within(kLongGrid.box()).inside;
        const Membership wanted(labels, kLongGrid, 1);
        const glm::ivec3 lo(*test::below(100), *test::below(20), *test::below(20));
        const Box3 box{lo, lo + glm::ivec3(1 + *test::below(80), 20, 20)};
        const auto bytes = membershipOf(fineOf(set), box, kLongGrid.spacing());
        double most = 0;
        forEachVoxel(intersect(box, kLongGrid.box()), [&](glm::ivec3 v, std::size_t) {
            const glm::ivec3 at = v - box.lo;
            const glm::ivec3 size = box.size();
            const double found =
                bytes.empty() ? 0
                              : double(bytes[(std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) *
                                                 std::size_t(size.x) +
                                             std::size_t(at.x)]) /
                                    255;
            most = std::max(most, std::abs(found - wanted.at(v)));
        });
        RC_ASSERT(most < 0.52 / 255);
    });
    EXPECT_TRUE(membershipOf(FineSet(kLongGrid.dims), {{3, 3, 3}, {30, 30, 30}}, {1, 1, 1}).empty());
}

} // namespace
} // namespace vs::segment

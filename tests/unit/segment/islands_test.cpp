// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/islands.h"

#include "base/error.h"
#include "segment/edits/set_algebra.h"
#include "test_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vs::segment {
namespace {

const volume::GridGeometry kGrid = volume::makeGeometry({24, 20, 18}, {1, 2, 5}); // 0.01 ml a voxel

// The island of `start` by a plain flood fill.
VoxelSet flood(const VoxelSet& set, glm::ivec3 start, Connectivity connectivity) {
    VoxelSet island = emptySet(set.box);
    std::vector<glm::ivec3> open{start};
    island.inside[island.indexOf(start)] = 1;
    while (!open.empty()) {
        const glm::ivec3 at = open.back();
        open.pop_back();
        forEachPlace({at - 1, at + 2}, [&](glm::ivec3 next) {
            const auto d = glm::abs(next - at);
            const bool isNeighbour = connectivity == Connectivity::TwentySix || d.x + d.y + d.z == 1;
            if (isNeighbour && set.contains(next) && !island.contains(next)) {
                island.inside[island.indexOf(next)] = 1;
                open.push_back(next);
            }
        });
    }
    return island;
}

class IslandsOf : public testing::TestWithParam<int> { // so many neighbours
protected:
    static Connectivity connectivity() {
        return GetParam() == 6 ? Connectivity::Six : Connectivity::TwentySix;
    }
};

INSTANTIATE_TEST_SUITE_P(Connectivities, IslandsOf, testing::Values(6, 26));

TEST_P(IslandsOf, RandomSetsAreThoseOfAPlainFloodFill) {
    // From scattered voxels past both percolation thresholds (about 0.1 and 0.3) to nearly everything: so
    // many voxels are drawn from a box of 5168, some of them more than once.
    for (const int most : {200, 1000, 3000, 10000}) {
        test::checkProperty(2, [&] {
            const VoxelSet set = *anySet({{3, 2, 1}, {22, 19, 17}}, most);
            RC_PRE(set.count() > 0U);
            VoxelSet rest = set;
            std::vector<Island> expected;
            forEachPlace(set.box, [&](glm::ivec3 voxel) {
                if (rest.contains(voxel)) {
                    const VoxelSet island = flood(set, voxel, connectivity());
                    expected.push_back({island.count(), voxel});
                    RC_ASSERT(keepIsland(set, voxel, connectivity()) == island);
                    RC_ASSERT(dropIsland(set, voxel, connectivity()) == subtract(set, island));
                    rest = subtract(rest, island);
                }
            });
            std::stable_sort(expected.begin(), expected.end(),
                             [](const Island& a, const Island& b) { return a.voxels > b.voxels; });
            RC_ASSERT((islands(set, connectivity()) == expected));
            RC_ASSERT(keepLargestIsland(set, connectivity()) ==
                      flood(set, expected.front().first, connectivity()));
        });
    }
}

TEST_P(IslandsOf, SmallOnesAreDroppedByVolume) {
    const VoxelSet set = randomSet(kGrid.box(), 0.12, 5);
    const VoxelSet kept = dropSmallIslands(set, kGrid, 0.03, connectivity());
    VoxelSet expected;
    for (const Island& island : islands(set, connectivity())) {
        if (island.voxels >= 3) {
            expected = unite(expected, flood(set, island.first, connectivity()));
        }
    }
    EXPECT_EQ(kept, expected);
    EXPECT_EQ(dropSmallIslands(set, kGrid, 0, connectivity()), set);
    EXPECT_EQ(dropSmallIslands(set, kGrid, 1e9, connectivity()), VoxelSet{});
}

TEST_P(IslandsOf, FillingLeavesTheOutsideAlone) {
    for (const double density : {0.3, 0.5, 0.8, 0.93}) {
        const VoxelSet set = randomSet(kGrid.box(), density, unsigned(100 * density));
        const VoxelSet filled = fillHoles(set, kGrid, 1e9, connectivity());
        // Outside the grid is outside: one layer around it joins what reaches the border.
        const Box3 around = grow(kGrid.box(), 1);
        const VoxelSet outside = complementIn(around, filled);
        EXPECT_EQ(islands(outside, connectivity()).size(), 1U);
        EXPECT_EQ(outside, flood(complementIn(around, set), around.lo, connectivity()));
    }
}

TEST(Islands, TouchingByAnEdgeCountsForTwentySixOnly) {
    const VoxelSet set = setWhere(
        kGrid.box(), [](glm::ivec3 v) { return v == glm::ivec3(4, 4, 4) || v == glm::ivec3(5, 5, 4); });
    EXPECT_EQ(islands(set, Connectivity::Six).size(), 2U);
    EXPECT_EQ(islands(set, Connectivity::TwentySix).size(), 1U);
}

TEST(Islands, EmptySetsHaveNone) {
    for (const VoxelSet& set : {VoxelSet{}, emptySet(kGrid.box())}) {
        EXPECT_TRUE(islands(set).empty());
        EXPECT_EQ(keepLargestIsland(set), VoxelSet{});
        EXPECT_EQ(dropSmallIslands(set, kGrid, 1), VoxelSet{});
        EXPECT_EQ(fillHoles(set, kGrid), VoxelSet{});
        EXPECT_THROW(keepIsland(set, {1, 1, 1}), Error);
    }
}

TEST(Islands, AClickBesideAnIslandMeansTheNearest) {
    const VoxelSet left = boxSet({{2, 2, 2}, {5, 8, 8}});
    const VoxelSet right = boxSet({{10, 2, 2}, {13, 8, 8}});
    const VoxelSet both = unite(left, right);
    EXPECT_EQ(keepIsland(both, {6, 4, 4}), left);
    EXPECT_EQ(keepIsland(both, {8, 4, 4}), right);
    EXPECT_EQ(dropIsland(both, {8, 4, 4}), left);
    EXPECT_EQ(keepIsland(both, {-1, 4, 4}), left) << "three voxels away, outside the grid";
    try {
        keepIsland(both, {16, 4, 10});
        FAIL() << "accepted a place far from everything";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "voxel 16,4,10 is more than 3 voxels away from the segment; take one on it");
    }
}

TEST(FillHoles, OnlyUpToTheLimit) {
    // Holes of 1 and 8 voxels.
    const VoxelSet set = subtract(boxSet({{2, 2, 2}, {14, 10, 10}}),
                                  unite(boxSet({{4, 4, 4}, {5, 5, 5}}), boxSet({{8, 4, 4}, {10, 6, 6}})));
    EXPECT_EQ(fillHoles(set, kGrid).count(), set.count() + 9);
    EXPECT_EQ(fillHoles(set, kGrid, 0.08).count(), set.count() + 9);
    EXPECT_EQ(fillHoles(set, kGrid, 0.07).count(), set.count() + 1);
    EXPECT_EQ(fillHoles(set, kGrid, 0).count(), set.count());
}

TEST(FillHoles, ALeakByAnEdgeIsNoneAcrossFaces) {
    // A box with a hole at its rim that the outside touches along an edge only.
    VoxelSet set = boxSet({{2, 2, 2}, {8, 8, 8}});
    set.inside[set.indexOf({3, 3, 4})] = 0;
    set.inside[set.indexOf({2, 2, 4})] = 0;
    EXPECT_TRUE(fillHoles(set, kGrid, 1e9, Connectivity::Six).contains({3, 3, 4}));
    EXPECT_FALSE(fillHoles(set, kGrid, 1e9, Connectivity::TwentySix).contains({3, 3, 4}));
}

TEST(FillHoles, DentsAtTheGridsBorderAreOutside) {
    const VoxelSet set = subtract(boxSet(kGrid.box()), boxSet({{0, 4, 4}, {3, 6, 6}}));
    EXPECT_EQ(fillHoles(set, kGrid), set);
}

} // namespace
} // namespace vs::segment

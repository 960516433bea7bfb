// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/set_algebra.h"
#include "test_sets.h"

#include <gtest/gtest.h>

namespace vs::segment {
namespace {

const Box3 kBox{{2, 3, 1}, {9, 8, 7}};

TEST(VoxelSet, TheEmptySetHoldsNothing) {
    for (const VoxelSet& set : {VoxelSet{}, emptySet(kBox)}) {
        EXPECT_EQ(set.count(), 0U);
        EXPECT_EQ(set.tightBox(), Box3{});
        EXPECT_FALSE(set.contains({0, 0, 0}));
        EXPECT_FALSE(set.contains({4, 4, 4}));
        EXPECT_EQ(set, VoxelSet{});
        EXPECT_EQ(set.cropped(3, {10, 10, 10}).box, Box3{});
        EXPECT_TRUE(set.tight().inside.empty());
    }
}

TEST(VoxelSet, IndicesAndVoxelsAreInverse) {
    const VoxelSet set = emptySet(kBox);
    std::size_t next = 0;
    forEachPlace(kBox, [&](glm::ivec3 voxel) {
        EXPECT_EQ(set.indexOf(voxel), next);
        EXPECT_EQ(set.voxelAt(next), voxel);
        ++next;
    });
}

TEST(VoxelSet, EachVoxelIsItsOwnTightBox) {
    forEachPlace(kBox, [&](glm::ivec3 only) {
        const VoxelSet set = setWhere(kBox, [&](glm::ivec3 voxel) { return voxel == only; });
        EXPECT_EQ(set.count(), 1U);
        EXPECT_EQ(set.tightBox(), (Box3{only, only + 1}));
        EXPECT_EQ(set.tight(), set);
    });
}

TEST(VoxelSet, TightBoxesTouchTheSetOnAllSides) {
    test::checkProperty(50, [] {
        const VoxelSet set = *anySet(kBox, 10);
        Box3 expected;
        forEachPlace(kBox, [&](glm::ivec3 voxel) {
            expected = set.contains(voxel) ? vs::unite(expected, Box3{voxel, voxel + 1}) : expected;
        });
        RC_ASSERT(set.tightBox() == expected);
    });
}

TEST(VoxelSet, CroppingPadsAndStaysInTheGrid) {
    const VoxelSet set = boxSet({{2, 3, 1}, {4, 5, 7}});
    EXPECT_EQ(set.cropped(2, {10, 6, 8}).box, (Box3{{0, 1, 0}, {6, 6, 8}}));
    EXPECT_EQ(set.cropped(2, {10, 6, 8}), set);
}

TEST(VoxelSet, WithinKeepsWhatLiesInTheOtherBox) {
    const VoxelSet set = randomSet(kBox, 0.5, 7);
    const Box3 others[] = {
        kBox, {{0, 0, 0}, {12, 12, 12}}, {{3, 4, 2}, {5, 6, 9}}, {{20, 20, 20}, {22, 22, 22}}};
    for (const Box3& other : others) {
        const VoxelSet part = set.within(other);
        EXPECT_EQ(part.box, other);
        forEachPlace({glm::ivec3(0), glm::ivec3(24)}, [&](glm::ivec3 voxel) {
            const bool isThere =
                glm::all(glm::greaterThanEqual(voxel, other.lo)) && glm::all(glm::lessThan(voxel, other.hi));
            EXPECT_EQ(part.contains(voxel), isThere && set.contains(voxel));
        });
    }
}

TEST(SetAlgebra, IsWhatItSaysForEveryVoxel) {
    for (const Box3& place : {Box3{{4, 2, 0}, {12, 6, 5}}, Box3{{20, 20, 20}, {24, 22, 25}}, kBox, Box3{}}) {
        test::checkProperty(5, [&place] {
            const VoxelSet a = *anySet(kBox, 200);
            const VoxelSet b = place == Box3{} ? VoxelSet{} : *anySet(place, 200);
            const VoxelSet united = unite(a, b);
            const VoxelSet rest = subtract(a, b);
            const VoxelSet shared = intersect(a, b);
            forEachPlace({glm::ivec3(-1), glm::ivec3(26)}, [&](glm::ivec3 v) {
                RC_ASSERT(united.contains(v) == (a.contains(v) || b.contains(v)));
                RC_ASSERT(rest.contains(v) == (a.contains(v) && !b.contains(v)));
                RC_ASSERT(shared.contains(v) == (a.contains(v) && b.contains(v)));
            });
            RC_ASSERT(united.box == united.tightBox());
            RC_ASSERT(rest.box == rest.tightBox());
            RC_ASSERT(shared.box == shared.tightBox());
        });
    }
}

TEST(SetAlgebra, Laws) {
    test::checkProperty(20, [] {
        const VoxelSet a = *anySet(kBox, 300);
        const VoxelSet b = *anySet({{4, 2, 0}, {12, 6, 5}}, 200);
        const VoxelSet c = *anySet({{0, 0, 0}, {7, 7, 7}}, 400);
        RC_ASSERT(unite(a, b) == unite(b, a));
        RC_ASSERT(intersect(a, b) == intersect(b, a));
        RC_ASSERT(intersect(a, unite(b, c)) == unite(intersect(a, b), intersect(a, c)));
        RC_ASSERT(subtract(a, unite(b, c)) == intersect(subtract(a, b), subtract(a, c)));
        RC_ASSERT(unite(subtract(a, b), intersect(a, b)) == a);
        RC_ASSERT(unite(a, a) == a);
        RC_ASSERT(subtract(a, a) == VoxelSet{});
        RC_ASSERT(unite(a, VoxelSet{}) == a);
        RC_ASSERT(unite(a, b).count() == a.count() + b.count() - intersect(a, b).count());
    });
}

} // namespace
} // namespace vs::segment

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
    forEachVoxel(kBox, [&](glm::ivec3 voxel) {
        EXPECT_EQ(set.indexOf(voxel), next);
        EXPECT_EQ(set.voxelAt(next), voxel);
        ++next;
    });
}

TEST(VoxelSet, EachVoxelIsItsOwnTightBox) {
    forEachVoxel(kBox, [&](glm::ivec3 only) {
        const VoxelSet set = setWhere(kBox, [&](glm::ivec3 voxel) { return voxel == only; });
        EXPECT_EQ(set.count(), 1U);
        EXPECT_EQ(set.tightBox(), (Box3{only, only + 1}));
        EXPECT_EQ(set.tight(), set);
    });
}

TEST(VoxelSet, TightBoxesTouchTheSetOnAllSides) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const VoxelSet set = randomSet(kBox, 0.02, seed);
        Box3 expected;
        forEachVoxel(kBox, [&](glm::ivec3 voxel) {
            expected = set.contains(voxel) ? vs::unite(expected, Box3{voxel, voxel + 1}) : expected;
        });
        EXPECT_EQ(set.tightBox(), expected);
    }
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
        forEachVoxel({glm::ivec3(0), glm::ivec3(24)}, [&](glm::ivec3 voxel) {
            const bool isThere =
                glm::all(glm::greaterThanEqual(voxel, other.lo)) && glm::all(glm::lessThan(voxel, other.hi));
            EXPECT_EQ(part.contains(voxel), isThere && set.contains(voxel));
        });
    }
}

TEST(SetAlgebra, IsWhatItSaysForEveryVoxel) {
    const Box3 places[] = {{{4, 2, 0}, {12, 6, 5}}, {{20, 20, 20}, {24, 22, 25}}, kBox, {}};
    for (const Box3& place : places) {
        const VoxelSet a = randomSet(kBox, 0.4, 1);
        const VoxelSet b = randomSet(place, 0.6, 2);
        const VoxelSet united = unite(a, b);
        const VoxelSet rest = subtract(a, b);
        const VoxelSet shared = intersect(a, b);
        forEachVoxel({glm::ivec3(-1), glm::ivec3(26)}, [&](glm::ivec3 v) {
            ASSERT_EQ(united.contains(v), a.contains(v) || b.contains(v));
            ASSERT_EQ(rest.contains(v), a.contains(v) && !b.contains(v));
            ASSERT_EQ(shared.contains(v), a.contains(v) && b.contains(v));
        });
        EXPECT_EQ(united.box, united.tightBox());
        EXPECT_EQ(rest.box, rest.tightBox());
        EXPECT_EQ(shared.box, shared.tightBox());
    }
}

TEST(SetAlgebra, Laws) {
    const VoxelSet a = randomSet(kBox, 0.5, 1);
    const VoxelSet b = randomSet({{4, 2, 0}, {12, 6, 5}}, 0.5, 2);
    const VoxelSet c = randomSet({{0, 0, 0}, {7, 7, 7}}, 0.5, 3);
    EXPECT_EQ(unite(a, b), unite(b, a));
    EXPECT_EQ(intersect(a, b), intersect(b, a));
    EXPECT_EQ(intersect(a, unite(b, c)), unite(intersect(a, b), intersect(a, c)));
    EXPECT_EQ(subtract(a, unite(b, c)), intersect(subtract(a, b), subtract(a, c)));
    EXPECT_EQ(unite(subtract(a, b), intersect(a, b)), a);
    EXPECT_EQ(unite(a, a), a);
    EXPECT_EQ(subtract(a, a), VoxelSet{});
    EXPECT_EQ(unite(a, VoxelSet{}), a);
    EXPECT_EQ(unite(a, b).count(), a.count() + b.count() - intersect(a, b).count());
}

} // namespace
} // namespace vs::segment

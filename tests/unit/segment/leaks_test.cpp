// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/leaks.h"

#include "property.h"
#include "segment/edits/set_algebra.h"
#include "test_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

namespace vs::segment {
namespace {

using test::below;

constexpr glm::ivec3 kSides(160, 60, 60);

// Voxels by generation of a region that grows in `body` from a voxel, 6-connected.
std::vector<std::uint64_t> grownFrom(glm::ivec3 seed, VoxelSet body) {
    std::vector<std::uint64_t> counts;
    std::deque<std::pair<glm::ivec3, int>> queue;
    const auto enter = [&](glm::ivec3 voxel, int generation) {
        if (!body.contains(voxel)) {
            return;
        }
        body.inside[body.indexOf(voxel)] = 0;
        counts.resize(std::max(counts.size(), std::size_t(generation)));
        ++counts[std::size_t(generation - 1)];
        queue.emplace_back(voxel, generation);
    };
    enter(seed, 1);
    while (!queue.empty()) {
        const auto [voxel, generation] = queue.front();
        queue.pop_front();
        for (int axis = 0; axis < 3; ++axis) {
            for (int side : {-1, 1}) {
                glm::ivec3 neighbour = voxel;
                neighbour[axis] += side;
                enter(neighbour, generation + 1);
            }
        }
    }
    return counts;
}

VoxelSet ballAt(glm::dvec3 middle, double radius) {
    return setWhere({glm::ivec3(0), kSides},
                    [&](glm::ivec3 voxel) { return glm::distance(glm::dvec3(voxel), middle) <= radius; });
}

VoxelSet tube(int from, int to, double radius) {
    return setWhere({glm::ivec3(0), kSides}, [&](glm::ivec3 voxel) {
        return voxel.x >= from && voxel.x <= to &&
               glm::distance(glm::dvec2(voxel.y, voxel.z), glm::dvec2(30)) <= radius;
    });
}

// Wherever its seed is: in bodies without narrow places nothing leaks.
TEST(Leaks, ThereAreNoneInBodiesWithoutNarrowPlaces) {
    const VoxelSet ball = ballAt({30, 30, 30}, 26);
    const VoxelSet block = boxSet({{2, 3, 4}, {90, 50, 30}});
    const VoxelSet vessel = tube(0, 159, 4);
    test::checkProperty(12, [&] {
        const glm::ivec3 place(*below(kSides.x), *below(kSides.y), *below(kSides.z));
        for (const VoxelSet* body : {&ball, &block, &vessel}) {
            if (body->contains(place)) {
                RC_ASSERT(leaks(grownFrom(place, *body), 1).empty());
            }
        }
    });
}

// Between entering the narrow place and filling the next body; what is shown there is the first body.
TEST(Leaks, OneIsFoundWhereABallRunsOutIntoALargerOne) {
    for (double radius : {0.0, 1.5, 3.0}) {
        const VoxelSet first = ballAt({22, 30, 30}, 14);
        const VoxelSet body = unite(unite(first, ballAt({90, 30, 30}, 28)), tube(22, 90, radius));
        const auto counts = grownFrom({22, 30, 30}, body);
        const auto found = leaks(counts, 1);
        ASSERT_EQ(found.size(), 1U) << "neck " << radius << ", at " << testing::PrintToString(found);
        std::uint64_t before = 0;
        for (int generation = 0; generation < found[0]; ++generation) {
            before += counts[std::size_t(generation)];
        }
        EXPECT_GE(double(before), 0.97 * double(first.count())) << "neck " << radius;
        EXPECT_LE(double(before), 1.15 * double(first.count()) + tube(36, 62, radius).count())
            << "neck " << radius;
    }
}

TEST(Leaks, AVesselThatOpensIntoAChamberLeaksThere) {
    const auto counts = grownFrom({0, 30, 30}, unite(tube(0, 100, 4), ballAt({125, 30, 30}, 27)));
    const auto found = leaks(counts, 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_GT(found[0], 90);
    EXPECT_LT(found[0], 112); // the front meets the chamber's wall all around by then
}

// A leak is told soon after it has begun, while the region still grows, and is not where new seeds began.
TEST(Leaks, AreToldWhileGrowingAndSparesNewSeeds) {
    const auto counts = grownFrom({0, 30, 30}, unite(tube(0, 100, 4), ballAt({125, 30, 30}, 27)));
    const int found = leaks(counts, 1).at(0);
    EXPECT_EQ(leaks(std::span(counts).first(std::size_t(found) + 18), 1), std::vector<int>{found});
    EXPECT_TRUE(leaks(std::span(counts).first(std::size_t(found)), 1).empty());

    auto seeded = grownFrom({30, 30, 30}, tube(0, 60, 2));
    const int begun = int(seeded.size()) + 1;
    const auto more = grownFrom({90, 30, 30}, ballAt({90, 30, 30}, 25));
    seeded.insert(seeded.end(), more.begin(), more.end());
    EXPECT_TRUE(leaks(seeded, begun).empty());
    EXPECT_FALSE(leaks(seeded, 1).empty()) << "what the seeds would look like otherwise";
}

TEST(Leaks, AtMostThreeAndAnyCountsWillDo) {
    EXPECT_TRUE(leaks({}, 0).empty());
    EXPECT_TRUE(leaks(std::vector<std::uint64_t>{5}, 1).empty());
    test::checkProperty(200, [&] {
        const auto counts =
            *rc::gen::container<std::vector<std::uint64_t>>(rc::gen::inRange<std::uint64_t>(0, 100000));
        const auto found = leaks(counts, *rc::gen::inRange(0, 5));
        RC_ASSERT(found.size() <= 3);
        RC_ASSERT(std::is_sorted(found.begin(), found.end()));
        RC_ASSERT((found.empty() || (found.front() > 0 && found.back() < int(counts.size()))));
    });
}

} // namespace
} // namespace vs::segment

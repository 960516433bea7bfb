// SPDX-License-Identifier: Apache-2.0
// Playback, late seeds, changed rules and undo: every log of calls gives what a plain queue gives that
// replays it.
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "segment/growth/growth_undo.h"

#include <limits>

namespace vs::segment {
namespace {

using GrowthLogTest = GrowthCase;

// Growth on the device and the reference side by side.
class Pair {
public:
    Pair(const volume::Volume& volume, const field::Field& field)
        : volume_(volume), growth(field, GrowthLogTest::GetParam()), queue(volume.geometry.dims) {}

    void setRange(Range range, Connectivity connectivity = Connectivity::Six) {
        Constraints constraints;
        constraints.range = range;
        constraints.connectivity = connectivity;
        growth.setConstraints(constraints);
        queue.setRules(admits(volume_, constraints), connectivity == Connectivity::TwentySix);
    }
    void addSeeds(const std::vector<glm::ivec3>& seeds) {
        growth.addSeeds(seeds);
        queue.addSeeds(seeds);
    }
    void advance(int generations) { EXPECT_EQ(growth.advance(generations), queue.advance(generations)); }
    void setPlayhead(int generation) {
        growth.setPlayhead(generation);
        queue.setPlayhead(generation);
    }
    void expectEqual(const std::string& what) const {
        EXPECT_EQ(growth.playhead(), queue.playhead()) << what;
        EXPECT_EQ(growth.extent(), queue.extent()) << what;
        EXPECT_TRUE(growth.generations(false) == queue.generations()) << what;
    }

private:
    const volume::Volume& volume_;

public:
    Growth growth;
    reference::QueueGrowth queue;
};

TEST_P(GrowthLogTest, AGenerationLooksTheSameFromEitherSide) {
    const auto volume = randomVolume({50, 40, 30}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    Constraints constraints;
    constraints.range = {0, 60};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{25, 20, 15}, {24, 20, 15}, {25, 21, 15}});
    std::vector<std::vector<std::uint32_t>> forward;
    std::vector<std::vector<std::uint8_t>> labels;
    forward.push_back(growth.generations(true));
    labels.push_back(growth.labels());
    while (growth.advance(1) == 1) {
        forward.push_back(growth.generations(true));
        labels.push_back(growth.labels());
    }
    ASSERT_GT(forward.size(), 20U);
    for (int g = int(forward.size()); g >= 1; --g) {
        EXPECT_EQ(growth.playhead(), g);
        EXPECT_TRUE(growth.generations(true) == forward[std::size_t(g) - 1]) << g;
        EXPECT_TRUE(growth.labels() == labels[std::size_t(g) - 1]) << g;
        EXPECT_EQ(growth.takeBack(1), 1);
    }
    EXPECT_EQ(growth.voxelCount(), 0U);
    EXPECT_EQ(growth.takeBack(1), 0);
    EXPECT_EQ(growth.advance(kAll), int(forward.size()));
    EXPECT_TRUE(growth.generations(true) == forward.back());
}

TEST_P(GrowthLogTest, AWiderRangeMidwayTakesUpWhatWasRefused) {
    const auto volume = randomVolume({50, 40, 30}, volume::ScalarType::Int16, -100, 100);
    const field::Field field = field::uploadVolume(volume);
    Pair pair(volume, field);
    pair.setRange({-100, -20});
    pair.addSeeds({{25, 20, 15}, {5, 5, 5}, {40, 35, 20}, {10, 30, 7}, {26, 20, 15}, {25, 21, 15}});
    pair.advance(4);
    pair.expectEqual("first range");
    pair.setRange({-100, 30});
    pair.advance(3);
    pair.expectEqual("wider range");
    pair.setRange({-100, 30}, Connectivity::TwentySix);
    pair.advance(2);
    pair.expectEqual("more neighbours");
    pair.setRange({-60, -10});
    pair.advance(kAll);
    pair.expectEqual("narrower range");
    EXPECT_TRUE(pair.growth.isFinished());
    pair.setRange({-100, 100});
    EXPECT_FALSE(pair.growth.isFinished());
    pair.advance(kAll);
    pair.expectEqual("everything");
    EXPECT_EQ(pair.growth.voxelCount(), volume.geometry.voxelCount());
}

TEST_P(GrowthLogTest, LateSeedsEnterAtThePlayhead) {
    const auto volume =
        phantom::makePhantom({40, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3) { return 10.0; });
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    Constraints constraints;
    constraints.range = {10, 10};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{0, 0, 0}});
    growth.advance(9);
    growth.takeBack(5);
    ASSERT_EQ(growth.playhead(), 5);
    ASSERT_EQ(growth.extent(), 10);
    growth.addSeeds(std::vector<glm::ivec3>{{30, 0, 0}, {1, 0, 0}, {6, 0, 0}});
    EXPECT_EQ(growth.extent(), 5);
    growth.advance(1);
    const auto generations = growth.generations(false);
    EXPECT_EQ(generations[30], 5U);
    EXPECT_EQ(generations[31], 6U);
    EXPECT_EQ(generations[1], 2U) << "a voxel keeps its smallest generation";
    EXPECT_EQ(generations[6], 5U) << "hidden generations do not count as grown";
    EXPECT_EQ(generations[8], 0U);
}

TEST_P(GrowthLogTest, RefusedSeedsLeaveHiddenGenerationsAlone) {
    const auto volume =
        phantom::makePhantom({16, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3 p) { return p.x; });
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    Constraints constraints;
    constraints.range = {0, 10};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{0, 0, 0}});
    growth.advance(8);
    growth.takeBack(4);
    const auto before = growth.generations(false);
    EXPECT_EQ(growth.addSeeds(std::vector<glm::ivec3>{{12, 0, 0}, {0, 0, 0}}).added, 0);
    EXPECT_EQ(growth.extent(), 9);
    growth.setConstraints(constraints);
    EXPECT_EQ(growth.extent(), 9) << "the same rules again change nothing";
    EXPECT_TRUE(growth.generations(false) == before);
}

TEST_P(GrowthLogTest, AdvanceForStopsInTimeAndGoesOnExactly) {
    const auto volume = randomVolume({64, 64, 64}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Pair pair(volume, field);
    pair.setRange({0, 70});
    pair.addSeeds({{32, 32, 32}, {0, 0, 0}, {60, 60, 60}, {20, 40, 10}});
    EXPECT_EQ(pair.growth.advanceFor(0.0, kAll), 1);
    while (!pair.growth.isFinished()) {
        pair.growth.advanceFor(5.0, kAll);
    }
    pair.queue.advance(kAll);
    pair.expectEqual("in slices of time");
}

TEST_P(GrowthLogTest, GrowthGoesOnExactlyAfterUndo) {
    const auto volume = randomVolume({45, 35, 40}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Pair pair(volume, field);
    pair.setRange({0, 60});
    pair.addSeeds({{20, 20, 20}, {30, 10, 10}, {5, 5, 5}, {21, 20, 20}});
    pair.advance(5);
    GrowthUndo undo;
    pair.growth.advance(4, &undo);
    EXPECT_LT(undo.bytes(), 4096U) << "growing forward needs no copy of voxels";
    undo.undo(pair.growth);
    pair.expectEqual("undone");
    pair.growth.addSeeds(std::vector<glm::ivec3>{{40, 30, 30}, {41, 30, 30}, {40, 31, 30}}, &undo);
    undo.undo(pair.growth);
    pair.expectEqual("seeds undone");
    pair.advance(kAll);
    pair.expectEqual("to the end");
}

INSTANTIATE_TEST_SUITE_P(OnDeviceAndHost, GrowthLogTest, kEngines, nameOfEngine);

} // namespace
} // namespace vs::segment

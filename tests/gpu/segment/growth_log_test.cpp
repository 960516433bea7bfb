// SPDX-License-Identifier: Apache-2.0
// Playback, late seeds, changed rules and undo: every log of calls gives what a plain queue gives that
// replays it.
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "segment/growth/growth_undo.h"

#include <limits>

namespace vs::segment {
namespace {

using GrowthLogTest = test::GlTest;
constexpr int kAll = std::numeric_limits<int>::max();

// Growth on the device and the reference side by side.
class Pair {
public:
    Pair(const volume::Volume& volume, const field::Field& field)
        : volume_(volume), growth(field), queue(volume.geometry.dims) {}

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

TEST_F(GrowthLogTest, AGenerationLooksTheSameFromEitherSide) {
    const auto volume = randomVolume({50, 40, 30}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
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

TEST_F(GrowthLogTest, AWiderRangeMidwayTakesUpWhatWasRefused) {
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

TEST_F(GrowthLogTest, LateSeedsEnterAtThePlayhead) {
    const auto volume =
        phantom::makePhantom({40, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3) { return 10.0; });
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
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

TEST_F(GrowthLogTest, RefusedSeedsLeaveHiddenGenerationsAlone) {
    const auto volume =
        phantom::makePhantom({16, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3 p) { return p.x; });
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
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

TEST_F(GrowthLogTest, AdvanceForStopsInTimeAndGoesOnExactly) {
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
    pair.expectEqual("in portions");
}

// One random call on the device (recorded in `undo`) and on the reference.
void randomCall(std::mt19937& random, const volume::Volume& volume, Growth& growth,
                reference::QueueGrowth& queue, GrowthUndo& undo) {
    switch (random() % 14) {
    case 8:
    case 0: {
        Constraints constraints;
        constraints.range = {double(random() % 30), double(40 + random() % 60)};
        constraints.connectivity = random() % 2 == 0 ? Connectivity::Six : Connectivity::TwentySix;
        if (random() % 3 == 0) {
            constraints.difference = {-double(random() % 40), double(random() % 40)};
        }
        if (random() % 4 == 0) {
            constraints.gradient = {double(random() % 10), double(30 + random() % 40)};
        }
        if (random() % 4 == 0) {
            constraints.gradientDifference = {-double(random() % 30), double(random() % 30)};
        }
        growth.setConstraints(constraints, &undo);
        queue.setRules(admits(volume, constraints), constraints.connectivity == Connectivity::TwentySix,
                       admitsFrom(volume, constraints));
        break;
    }
    case 9: {
        const bool isLive = random() % 2 == 0;
        growth.setLive(isLive, &undo);
        queue.setLive(isLive);
        break;
    }
    case 10: {
        const std::vector<glm::ivec3> stroke{{20, 20, 20}, {random() % 45, random() % 35, random() % 40}};
        const int expansions = int(random() % 6);
        EXPECT_EQ(growth.absorb(stroke, expansions, &undo), queue.absorb(stroke, expansions));
        break;
    }
    case 11:
        if (random() % 3 == 0) {
            std::vector<std::uint8_t> inside = growth.labels();
            for (std::uint8_t& value : inside) {
                value = random() % 8 == 0 ? 1 - value : value;
            }
            growth.replace(volume.geometry.box(), inside, &undo);
            queue.replace(inside);
            break;
        }
        [[fallthrough]];
    case 1:
    case 2: {
        std::vector<glm::ivec3> seeds;
        for (unsigned int i = 0; i < 1 + random() % 5; ++i) {
            seeds.emplace_back(random() % 45, random() % 35, random() % 40);
        }
        growth.addSeeds(seeds, &undo);
        queue.addSeeds(seeds);
        break;
    }
    case 3: {
        const int back = int(random() % 6);
        growth.takeBack(back, &undo);
        queue.takeBack(back);
        break;
    }
    case 4: {
        const int to = int(random() % 12);
        growth.setPlayhead(to, &undo);
        queue.setPlayhead(to);
        break;
    }
    case 5:
        if (random() % 4 == 0) {
            growth.reset(&undo);
            queue.reset();
            break;
        }
        [[fallthrough]];
    default: {
        const int forward = 1 + int(random() % 4);
        EXPECT_EQ(growth.advance(forward, &undo), queue.advance(forward));
    }
    }
}

TEST_F(GrowthLogTest, RandomLogsEqualTheQueueAndUndoRestoresEveryByte) {
    const auto volume = randomVolume({45, 35, 40}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    for (unsigned int seed = 1; seed <= 12; ++seed) {
        std::mt19937 random(seed);
        Pair pair(volume, field);
        pair.setRange({0, 60});
        struct Moment {
            GrowthState state;
            std::vector<std::uint32_t> map;
            GrowthUndo undo;
        };
        std::vector<Moment> moments;
        for (int call = 0; call < 40; ++call) {
            moments.push_back({pair.growth.state(), pair.growth.generations(false), {}});
            randomCall(random, volume, pair.growth, pair.queue, moments.back().undo);
            pair.expectEqual(fmt::format("log {}, call {}", seed, call));
        }
        for (; !moments.empty(); moments.pop_back()) {
            moments.back().undo.undo(pair.growth);
            EXPECT_TRUE(pair.growth.generations(false) == moments.back().map)
                << seed << " " << moments.size();
            EXPECT_TRUE(pair.growth.state() == moments.back().state) << seed << " " << moments.size();
        }
    }
}

TEST_F(GrowthLogTest, GrowthGoesOnExactlyAfterUndo) {
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

} // namespace
} // namespace vs::segment

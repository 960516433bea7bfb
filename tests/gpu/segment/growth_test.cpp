// SPDX-License-Identifier: Apache-2.0
// The region and every generation against a plain queue.
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"

#include <algorithm>
#include <limits>

namespace vs::segment {
namespace {

using GrowthTest = GrowthCase;

void expectEqualsReference(const volume::Volume& volume, const Constraints& constraints,
                           const std::vector<glm::ivec3>& seeds, const std::string& what) {
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GrowthTest::GetParam());
    growth.setConstraints(constraints);
    growth.addSeeds(seeds);
    growth.advance(kAll);

    reference::QueueGrowth queue(volume.geometry.dims);
    queue.setRules(admits(volume, constraints), constraints.connectivity == Connectivity::TwentySix);
    queue.addSeeds(seeds);
    queue.advance(kAll);
    EXPECT_EQ(growth.extent(), queue.extent()) << what;
    EXPECT_TRUE(growth.isFinished()) << what;
    EXPECT_TRUE(growth.generations(false) == queue.generations()) << what;
    const auto inside = std::count_if(queue.generations().begin(), queue.generations().end(),
                                      [](std::uint32_t g) { return g != 0; });
    EXPECT_EQ(growth.voxelCount(), std::uint64_t(inside)) << what;
}

TEST_P(GrowthTest, EveryGenerationEqualsAPlainQueueOnEveryScalarType) {
    using enum volume::ScalarType;
    const glm::ivec3 dims(37, 21, 19);
    for (const auto type : {UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32}) {
        const bool isUnsigned = type == UInt8 || type == UInt16 || type == UInt32;
        const auto volume = randomVolume(dims, type, isUnsigned ? 0 : -100, 100);
        for (const double density : {0.25, 0.5, 0.8}) {
            const double lo = isUnsigned ? 0 : -100;
            for (const auto connectivity : {Connectivity::Six, Connectivity::TwentySix}) {
                Constraints constraints;
                constraints.range = {lo, lo + density * (100 - lo)};
                constraints.connectivity = connectivity;
                std::vector<glm::ivec3> seeds;
                for (int i = 0; i < 40; ++i) {
                    seeds.emplace_back(i * 7 % dims.x, i * 5 % dims.y, i * 3 % dims.z);
                }
                expectEqualsReference(volume, constraints, seeds,
                                      volume::name(type) + fmt::format(" {}", density));
            }
        }
    }
}

TEST_P(GrowthTest, SizesThatFillNoWordOrBrick) {
    for (const glm::ivec3 dims :
         {glm::ivec3(1, 1, 1), glm::ivec3(1, 1, 77), glm::ivec3(5, 3, 1), glm::ivec3(33, 65, 34)}) {
        const auto volume = randomVolume(dims, volume::ScalarType::UInt8, 0, 100, 3);
        for (const auto connectivity : {Connectivity::Six, Connectivity::TwentySix}) {
            Constraints constraints;
            constraints.range = {0, 90};
            constraints.connectivity = connectivity;
            expectEqualsReference(volume, constraints, {{0, 0, 0}, dims - 1, dims / 2},
                                  fmt::format("{}", dims.z));
        }
    }
}

TEST_P(GrowthTest, RepeatedRunsAreTheSame) {
    const auto volume = randomVolume({64, 48, 40}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    Constraints constraints;
    constraints.range = {0, 55};
    growth.setConstraints(constraints);
    std::vector<std::uint32_t> first;
    for (int run = 0; run < 4; ++run) {
        growth.reset();
        growth.addSeeds(std::vector<glm::ivec3>{{5, 5, 5}, {40, 30, 20}, {1, 2, 3}, {60, 3, 3}});
        growth.advance(kAll);
        auto generations = growth.generations(false);
        if (run > 0) {
            EXPECT_TRUE(generations == first);
        }
        first = std::move(generations);
    }
    EXPECT_GT(growth.voxelCount(), 1000U);
}

TEST_P(GrowthTest, CorridorOfThousandsOfGenerations) {
    // One voxel wide, winding through every second row of every second slice.
    const glm::ivec3 dims(41, 39, 9);
    auto volume = phantom::makePhantom(dims, volume::ScalarType::UInt8, [&](glm::dvec3 p) {
        const glm::ivec3 v(p);
        if (v.z % 2 == 1) { // shafts between floors, alternately at the first and the last corner
            const bool atEnd = v.z / 2 % 2 == 0;
            return v.x == 0 && v.y == (atEnd ? dims.y - 1 : 0) ? 200.0 : 0.0;
        }
        if (v.y % 2 == 1) { // doors between rows, alternately right and left
            return v.x == (v.y / 2 % 2 == 0 ? dims.x - 1 : 0) ? 200.0 : 0.0;
        }
        return 200.0;
    });
    Constraints constraints;
    constraints.range = {100, 255};
    expectEqualsReference(volume, constraints, {{0, 0, 0}}, "corridor");
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{0, 0, 0}});
    EXPECT_GT(growth.advance(kAll), 2000);
}

TEST_P(GrowthTest, SolidBlockGrowsByDistance) {
    const glm::ivec3 dims(200);
    const auto volume =
        phantom::makePhantom(dims, volume::ScalarType::UInt8, [](glm::dvec3) { return 100.0; });
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    const glm::ivec3 seed(20, 100, 199);
    for (const auto connectivity : {Connectivity::Six, Connectivity::TwentySix}) {
        Constraints constraints;
        constraints.range = {50, 150};
        constraints.connectivity = connectivity;
        growth.reset();
        growth.setConstraints(constraints);
        growth.addSeeds(std::span(&seed, 1));
        growth.advance(kAll);
        ASSERT_EQ(growth.voxelCount(), volume.geometry.voxelCount());
        const auto generations = growth.generations(true);
        std::size_t wrong = 0;
        std::size_t i = 0;
        for (int z = 0; z < dims.z; ++z) {
            for (int y = 0; y < dims.y; ++y) {
                for (int x = 0; x < dims.x; ++x, ++i) {
                    const glm::ivec3 d = glm::abs(glm::ivec3(x, y, z) - seed);
                    const int distance =
                        connectivity == Connectivity::Six ? d.x + d.y + d.z : std::max({d.x, d.y, d.z});
                    wrong += generations[i] != std::uint32_t(distance + 1) ? 1 : 0;
                }
            }
        }
        EXPECT_EQ(wrong, 0U);
    }
}

TEST_P(GrowthTest, RangesAreComparedExactly) {
    // Values one apart at the ends of 16-bit data, and floats that no decimal number names.
    const auto count = [](const volume::Volume& volume, Range range) {
        const field::Field field = field::uploadVolume(volume);
        Growth growth(field, GetParam());
        Constraints constraints;
        constraints.range = range;
        growth.setConstraints(constraints);
        std::vector<glm::ivec3> all;
        for (int x = 0; x < volume.geometry.dims.x; ++x) {
            all.emplace_back(x, 0, 0);
        }
        return growth.addSeeds(all).added;
    };
    const auto ramp16 = phantom::makePhantom({256, 1, 1}, volume::ScalarType::Int16,
                                             [](glm::dvec3 p) { return 32512 + p.x; });
    EXPECT_EQ(count(ramp16, {32600, 32700}), 101);
    EXPECT_EQ(count(ramp16, {32599.5, 32700.5}), 101);
    EXPECT_EQ(count(ramp16, {32600.1, 32600.9}), 0);
    const auto low16 = phantom::makePhantom({256, 1, 1}, volume::ScalarType::Int16,
                                            [](glm::dvec3 p) { return -32768 + p.x; });
    EXPECT_EQ(count(low16, {-1e9, -32700}), 69);
    const auto large = phantom::makePhantom({256, 1, 1}, volume::ScalarType::Int32,
                                            [](glm::dvec3 p) { return 16776960 + p.x; });
    EXPECT_EQ(count(large, {16777000, 16777100}), 101);
    const auto tenths =
        phantom::makePhantom({11, 1, 1}, volume::ScalarType::Float32, [](glm::dvec3 p) { return p.x / 10; });
    EXPECT_EQ(count(tenths, {0.1, 0.7}), 7) << "0.1F is above 0.1 and 0.7F below 0.7";
    EXPECT_EQ(count(tenths, {0.3, 0.6}), 4);
}

TEST_P(GrowthTest, NonFiniteVoxelsAreNeverEntered) {
    auto volume =
        phantom::makePhantom({8, 1, 1}, volume::ScalarType::Float32, [](glm::dvec3) { return 1.0; });
    reinterpret_cast<float*>(volume.bytes.data())[4] = std::numeric_limits<float>::quiet_NaN();
    volume::computeRange(volume);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    Constraints constraints;
    constraints.range = {-1e300, 1e300};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{0, 0, 0}});
    growth.advance(kAll);
    EXPECT_EQ(growth.voxelCount(), 4U);
}

TEST_P(GrowthTest, SeedsAreCountedAsAddedPresentOrRefused) {
    const auto volume =
        phantom::makePhantom({16, 16, 16}, volume::ScalarType::UInt8, [](glm::dvec3 p) { return p.x; });
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GetParam());
    Constraints constraints;
    constraints.range = {4, 7};
    growth.setConstraints(constraints);
    const auto counts = growth.addSeeds(std::vector<glm::ivec3>{
        {4, 0, 0}, {4, 0, 0}, {7, 1, 1}, {8, 1, 1}, {-1, 0, 0}, {5, 16, 0}, {3, 3, 3}});
    EXPECT_EQ(counts.added, 2);
    EXPECT_EQ(counts.present, 1);
    EXPECT_EQ(counts.refused, 4);
    EXPECT_EQ(growth.playhead(), 1);
    EXPECT_EQ(growth.voxelCount(), 2U);
    EXPECT_EQ(growth.addSeeds(std::vector<glm::ivec3>{{4, 0, 0}}).present, 1);
}

TEST_P(GrowthTest, StaysOnItsSideOfTheSculpture) {
    const glm::ivec3 dims(40, 30, 20);
    const auto volume = randomVolume(dims, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    gl::Texture sculpture(dims, gl::Format::R8, gl::Filter::Linear, "test sculpture");
    std::vector<std::uint8_t> cut(volume.geometry.voxelCount());
    std::mt19937 random(5);
    std::generate(cut.begin(), cut.end(), [&] { return std::uint8_t(random() % 4 == 0 ? 128 : 127); });
    sculpture.upload({glm::ivec3(0), dims}, std::as_bytes(std::span(cut)));
    for (const auto view :
         {field::SculptureView::Whole, field::SculptureView::Cut, field::SculptureView::Probe}) {
        Constraints constraints;
        constraints.range = {0, 80};
        constraints.sculpture = &sculpture;
        constraints.view = view;
        constraints.connectivity = Connectivity::TwentySix;
        Growth growth(field, GetParam());
        growth.setConstraints(constraints);
        std::vector<glm::ivec3> seeds;
        for (int i = 0; i < 30; ++i) {
            seeds.emplace_back(i, i % 30, i % 20);
        }
        growth.addSeeds(seeds);
        growth.advance(kAll);
        reference::QueueGrowth queue(dims);
        queue.setRules(admits(volume, constraints, cut), true);
        queue.addSeeds(seeds);
        queue.advance(kAll);
        EXPECT_TRUE(growth.generations(false) == queue.generations());
        EXPECT_GT(growth.voxelCount(), 100U);
    }
}

INSTANTIATE_TEST_SUITE_P(OnDeviceAndHost, GrowthTest, kEngines, nameOfEngine);

} // namespace
} // namespace vs::segment

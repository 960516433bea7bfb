// SPDX-License-Identifier: Apache-2.0
// Rules about differences and gradients: every voxel and every generation as a plain queue gives them.
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"

#include <algorithm>
#include <limits>

namespace vs::segment {
namespace {

using GrowthRulesTest = GrowthCase;

// A blurred random volume: neighbours differ little enough for growth to get somewhere.
volume::Volume softVolume(volume::ScalarType type, glm::dvec3 spacing) {
    const glm::ivec3 dims(45, 38, 27);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> phase(0, 6.28);
    std::uniform_real_distribution<double> noise(-6, 6);
    const glm::dvec3 a(phase(random), phase(random), phase(random));
    return phantom::makePhantom(
        dims, type,
        [&](glm::dvec3 p) {
            return 100 + 35 * std::sin(0.31 * p.x + a.x) + 30 * std::cos(0.23 * p.y + a.y) +
                   25 * std::sin(0.4 * p.z + 0.2 * p.x + a.z) + noise(random);
        },
        spacing);
}

void expectSameAsQueue(const volume::Volume& volume, const Constraints& constraints,
                       const std::string& what) {
    const field::Field field = field::uploadVolume(volume);
    const std::vector<glm::ivec3> seeds{{22, 19, 13}, {3, 3, 3}, {40, 30, 20}, {10, 30, 5}};
    std::vector<std::uint32_t> first;
    for (int run = 0; run < 2; ++run) {
        Growth growth(field, GrowthRulesTest::GetParam());
        growth.setConstraints(constraints);
        reference::QueueGrowth queue(volume.geometry.dims);
        queue.setRules(admits(volume, constraints), constraints.connectivity == Connectivity::TwentySix,
                       admitsFrom(volume, constraints));
        growth.addSeeds(seeds);
        queue.addSeeds(seeds);
        EXPECT_EQ(growth.advance(kAll), queue.advance(kAll)) << what;
        EXPECT_TRUE(growth.generations(false) == queue.generations()) << what;
        EXPECT_GT(growth.voxelCount(), 200U) << what << ": there must be something to compare";
        EXPECT_LT(growth.voxelCount(), volume.geometry.voxelCount()) << what;
    }
}

TEST_P(GrowthRulesTest, EveryRuleEqualsAPlainQueue) {
    for (const auto type :
         {volume::ScalarType::UInt8, volume::ScalarType::Int16, volume::ScalarType::Float32}) {
        for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(0.7, 0.9, 2.5)}) {
            const auto volume = softVolume(type, spacing);
            for (const auto connectivity : {Connectivity::Six, Connectivity::TwentySix}) {
                Constraints plain;
                plain.range = {20, 180};
                plain.connectivity = connectivity;
                Constraints difference = plain;
                difference.difference = {-4, 7};
                Constraints gradient = plain;
                gradient.gradient = {3, 11};
                Constraints steeper = plain;
                steeper.gradientDifference = {-2.5, 2};
                Constraints all = difference;
                all.difference = {-9, 11};
                all.gradient = {1, 14};
                all.gradientDifference = {-6, 5};
                const std::string where = fmt::format("type {}, spacing {}, {} neighbours", int(type),
                                                      spacing.z, connectivity == Connectivity::Six ? 6 : 26);
                expectSameAsQueue(volume, difference, where + ", difference");
                expectSameAsQueue(volume, gradient, where + ", gradient");
                expectSameAsQueue(volume, steeper, where + ", gradient difference");
                expectSameAsQueue(volume, all, where + ", all");
            }
        }
    }
}

// Values of a file with a slope and an intercept, and rules whose ends are such values: what was stored
// decides, not what rounding makes of it.
TEST_P(GrowthRulesTest, EndsOfRulesAreMetExactlyByScaledValues) {
    const auto stored = softVolume(volume::ScalarType::UInt8, glm::dvec3(1));
    for (const double slope : {0.1, -0.3, 1.0 / 3, 1e-3}) {
        volume::Volume scaled = stored;
        scaled.type = volume::ScalarType::Float32;
        scaled.details.slope = slope;
        scaled.details.intercept = 7.7;
        const auto valueOf = [&](double number) { return double(float(slope * number + 7.7)); };
        scaled.bytes.resize(4 * stored.bytes.size());
        std::transform(stored.bytes.begin(), stored.bytes.end(),
                       reinterpret_cast<float*>(scaled.bytes.data()),
                       [&](std::byte number) { return float(valueOf(std::to_integer<int>(number))); });
        volume::computeRange(scaled);
        const field::Field field = field::uploadVolume(scaled);
        ASSERT_EQ(field.texels.format(), gl::Format::R8);
        Constraints inNumbers;
        inNumbers.range = {40, 170};
        inNumbers.difference = {-4, 7};
        Constraints inValues;
        inValues.range = {std::min(valueOf(40), valueOf(170)), std::max(valueOf(40), valueOf(170))};
        inValues.difference = {std::min(-4 * slope, 7 * slope), std::max(-4 * slope, 7 * slope)};
        Growth growth(field, GetParam());
        growth.setConstraints(inValues);
        reference::QueueGrowth queue(stored.geometry.dims);
        queue.setRules(admits(stored, inNumbers), false, admitsFrom(stored, inNumbers));
        const std::vector<glm::ivec3> seeds{{22, 19, 13}, {3, 3, 3}, {40, 30, 20}, {10, 30, 5}};
        growth.addSeeds(seeds);
        queue.addSeeds(seeds);
        EXPECT_EQ(growth.advance(kAll), queue.advance(kAll)) << slope;
        EXPECT_TRUE(growth.generations(false) == queue.generations()) << slope;
        EXPECT_GT(growth.voxelCount(), 200U) << slope;
    }
}

// Edges and corners of tiles that are another brick's along one axis only.
TEST_P(GrowthRulesTest, DiagonalNeighboursAreMetAcrossBricks) {
    const auto volume = softVolume(volume::ScalarType::UInt8, glm::dvec3(1));
    const field::Field field = field::uploadVolume(volume);
    Constraints all;
    all.range = {-1000, 1000};
    all.connectivity = Connectivity::TwentySix;
    for (const glm::ivec3 seed : {glm::ivec3(8, 31, 20), glm::ivec3(23, 31, 8), glm::ivec3(31, 8, 15),
                                  glm::ivec3(32, 15, 16), glm::ivec3(16, 32, 7), glm::ivec3(31, 31, 24)}) {
        Growth growth(field, GetParam());
        growth.setConstraints(all);
        reference::QueueGrowth queue(volume.geometry.dims);
        queue.setRules(admits(volume, all), true, admitsFrom(volume, all));
        const std::vector<glm::ivec3> seeds{seed};
        growth.addSeeds(seeds);
        queue.addSeeds(seeds);
        for (int generation = 0; generation < 3; ++generation) {
            EXPECT_EQ(growth.advance(1), queue.advance(1));
            EXPECT_TRUE(growth.generations(false) == queue.generations()) << seed.x << ' ' << seed.y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OnDeviceAndHost, GrowthRulesTest, kEngines, nameOfEngine);

} // namespace
} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#include "tool_fixture.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace vs::sculpt {
namespace {

using PeelTest = test::GlTest;
using test::peel;
using test::Workpiece;

const glm::ivec3 kPeelDims(96, 96, 72);
const glm::dvec3 kPeelCentre(48, 48, 66); // the sphere of radius 60 comes nearest at z = 6
constexpr double kRadius = 60;

// Where the cut ends along the sphere's radius through (x, y), as a distance from the centre.
double radiusLeft(const std::vector<float>& values, glm::dvec2 e) {
    const glm::dvec2 off = e - glm::dvec2(kPeelCentre);
    const glm::dvec3 normal(off / kRadius, -std::sqrt(kRadius * kRadius - glm::dot(off, off)) / kRadius);
    return kRadius - test::crossingOf(values, kPeelDims, kPeelCentre + kRadius * normal, -normal, 20);
}

TEST_F(PeelTest, LayersComeOffASphere) {
    const auto mask = rasterize(circleOutline({48, 48}, 24), 0.5);
    const auto surface = test::sphereUnder(mask, kPeelCentre, kRadius);
    for (const double layers : {1.0, 2.5, 6.0}) {
        Workpiece piece(kPeelDims);
        piece.cut(surface, mask, peel(layers));
        const auto values = piece.values();
        double squared = 0;
        int count = 0;
        for (double y = -18; y <= 18; y += 1.3) {
            for (double x = -18; x <= 18; x += 1.3) {
                if (x * x + y * y < 19 * 19) {
                    const double off = radiusLeft(values, {48 + x, 48 + y}) - (kRadius - layers);
                    squared += off * off;
                    ++count;
                }
            }
        }
        EXPECT_LT(std::sqrt(squared / count), 0.2) << layers;
        // Beyond the mask and its blur nothing has changed.
        for (int z = 0; z < kPeelDims.z; ++z) {
            for (int y = 0; y < kPeelDims.y; ++y) {
                for (int x = 0; x < kPeelDims.x; ++x) {
                    if (std::hypot(x - 48, y - 48) > 24 + 2 + 4) {
                        ASSERT_EQ(values[std::size_t((z * kPeelDims.y + y) * kPeelDims.x + x)], 0.0F);
                    }
                }
            }
        }
    }
}

TEST_F(PeelTest, DivergingPathsLeaveNoGaps) {
    // From inside a hollow sphere of radius 14, 12 layers outwards: paths come to lie almost twice as far
    // apart.
    const glm::ivec3 dims(64, 64, 64);
    const glm::dvec3 centre(32, 32, 24);
    const auto mask = rasterize(circleOutline({0, 0}, 0.7), 0.06);
    Workpiece piece(dims);
    piece.cut(test::hollowSphereUnder(mask, centre, 14), mask, peel(12));
    const auto values = piece.values();
    float lowest = 1;
    double squared = 0;
    int count = 0;
    for (double y = -0.5; y <= 0.5; y += 0.05) {
        for (double x = -0.5; x <= 0.5; x += 0.05) {
            const glm::dvec3 way = glm::normalize(glm::dvec3(x, y, 1));
            if (x * x + y * y > 0.4 * 0.4) {
                continue;
            }
            for (double r = 14; r <= 23; r += 0.5) {
                lowest = std::min(lowest, test::sampleGrid(values, dims, centre + r * way));
            }
            const double off = test::crossingOf(values, dims, centre + 14.0 * way, way, 20) - 12;
            squared += off * off;
            ++count;
        }
    }
    EXPECT_GT(lowest, 0.97F);
    EXPECT_LT(std::sqrt(squared / count), 0.2);
}

TEST_F(PeelTest, PathsThatMeetDoNotPileUp) {
    // Twenty layers off a ball of radius 10: the paths cross at its centre.
    const glm::ivec3 dims(48);
    const glm::dvec3 centre(24, 24, 20);
    const auto mask = rasterize(circleOutline({24, 24}, 7), 0.5);
    const auto patches =
        sweepSurface(test::sphereUnder(mask, centre, 10), mask, volume::makeGeometry(dims), peel(20).sweep);
    Radiator radiator;
    PointGenerator generator;
    radiator.begin(patches.pointBox(), dims, fitFootprint(3));
    generator.generate(patches,
                       [&](const gl::Buffer& points, std::size_t count) { radiator.deposit(points, count); });
    radiator.finish();
    const auto e = radiator.download({glm::ivec3(0), dims});
    EXPECT_LE(*std::max_element(e.begin(), e.end()), 1.3F);
    // Beyond the centre nothing: what has crossed carries no energy.
    EXPECT_LT(test::sampleGrid(e, dims, {24, 24, 26}), 0.1F);
}

TEST_F(PeelTest, RoughNormalsDoNotScatterThePaths) {
    const auto mask = rasterize(circleOutline({48, 48}, 24), 0.5);
    auto surface = test::sphereUnder(mask, kPeelCentre, kRadius);
    std::mt19937 random(11);
    std::normal_distribution<float> noise(0, 0.4F);
    for (auto& point : surface) {
        const glm::vec3 rough =
            glm::vec3(point.normal) + glm::vec3(noise(random), noise(random), noise(random));
        point.normal = glm::vec4(glm::normalize(rough), 0);
    }
    Workpiece piece(kPeelDims);
    piece.cut(surface, mask, peel(6));
    const auto values = piece.values();
    for (double x = -16; x <= 16; x += 1.7) {
        EXPECT_NEAR(radiusLeft(values, {48 + x, 48 + 0.3 * x}), kRadius - 6, 0.3) << x;
    }
}

TEST_F(PeelTest, TheMasksDensityDoesNotMatter) {
    std::vector<std::vector<float>> results;
    for (const double pitch : {0.5, 0.25}) {
        const auto mask = rasterize(circleOutline({48, 48}, 24), pitch);
        Workpiece piece(kPeelDims);
        piece.cut(test::sphereUnder(mask, kPeelCentre, kRadius), mask, peel(3));
        results.push_back(piece.values());
    }
    EXPECT_LE(test::largestDifference(results[0], results[1]), 0.02F);
}

} // namespace
} // namespace vs::sculpt

// SPDX-License-Identifier: Apache-2.0
#include "field/gradient.h"

#include "gl/context.h"
#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "reference/gradient.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace vs::field {
namespace {

using GradientTest = test::GlTest;

// Random waves on an oblique grid with three different spacings.
volume::Volume makeWaves(volume::ScalarType type, glm::ivec3 dims = {37, 21, 19}) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-20, 20);
    auto volume = phantom::makePhantom(dims, type, [&](glm::dvec3 p) {
        return 100 + 60 * std::sin(0.3 * p.x) * std::cos(0.4 * p.y + 0.2 * p.z) + noise(random);
    });
    volume.geometry.worldFromVoxel =
        glm::dmat4({0.6, 0.3, 0, 0}, {-0.4, 0.9, 0.1, 0}, {0.2, 0, 2.5, 0}, {10, -20, 30, 1});
    return volume;
}

std::uint64_t total(const std::vector<std::uint32_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
}

int binOf(double x, const Range& range, int bins) {
    return std::clamp(int((x - range.lo) / range.width() * bins), 0, bins - 1);
}

// How many voxels stand in another bin.
std::uint64_t moved(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::uint64_t(std::abs(std::int64_t(a[i]) - std::int64_t(b[i])));
    }
    return sum / 2;
}

TEST_F(GradientTest, HistogramsEqualThoseCountedOnTheCpu) {
    using enum volume::ScalarType;
    for (const auto type : {UInt8, Int16, Float32}) {
        const auto volume = makeWaves(type);
        const Field field = uploadVolume(volume);
        const auto magnitudes = reference::gradientMagnitudes(volume);
        const Range gradients{0, 45};
        constexpr glm::ivec2 bins{53, 32};
        std::vector<std::uint32_t> expected(std::size_t(bins.y));
        std::vector<std::uint32_t> expectedJoint(std::size_t(bins.x * bins.y));
        const glm::ivec3 dims = volume.geometry.dims;
        for (std::size_t i = 0; i < magnitudes.size(); ++i) {
            if (magnitudes[i] <= gradients.hi) {
                const int n = int(i);
                const double value = volume.at({n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y});
                const int row = binOf(magnitudes[i], gradients, bins.y);
                ++expected[std::size_t(row)];
                ++expectedJoint[std::size_t(row * bins.x + binOf(value, volume.range, bins.x))];
            }
        }
        const auto counts = gradientHistogram(field, gradients, bins.y);
        const auto joint = jointHistogram(field, gradients, bins);
        EXPECT_LT(total(counts), magnitudes.size()) << "some lie above the range";
        EXPECT_EQ(joint.bins, bins);
        EXPECT_EQ(joint.values, volume.range);
        // On a bin's border single precision may fall to either side.
        EXPECT_LE(moved(counts, expected), 4U) << name(type);
        EXPECT_LE(moved(joint.counts, expectedJoint), 8U) << name(type);
    }
}

TEST_F(GradientTest, WhatIsKeptIsWhatWasCounted) {
    using enum volume::ScalarType;
    for (const auto type : {UInt8, Int16, Float32}) {
        const auto volume = makeWaves(type);
        const Field field = uploadVolume(volume);
        const auto magnitudes = reference::gradientMagnitudes(volume);
        const double usual = gradientRange(field).hi;
        const GradientField kept = computeGradients(field, usual);
        ASSERT_EQ(bool(kept.quads), gl::Context::isSoftware() && gl::pretendedFilterSteps() == 0);
        ASSERT_NE(bool(kept.quads), bool(kept.texels));
        const auto quads = kept.quads ? kept.quads.buffer().read<std::uint16_t>(4 * magnitudes.size())
                                      : std::vector<std::uint16_t>();
        const auto texels = kept.texels ? kept.texels.downloadAll<std::uint16_t>() : quads;
        const auto cells = kept.cells.downloadAll<glm::vec2>();
        const glm::ivec3 dims = volume.geometry.dims;
        const glm::ivec3 cellCount = kept.cells.size();
        const int pitch = kept.quads ? 4 : 1;
        forEachVoxel({glm::ivec3(0), dims}, [&](glm::ivec3 v, std::size_t n) {
            const double value = kept.most * texels[n * std::size_t(pitch)] / 65535.0;
            ASSERT_NEAR(value, magnitudes[n], kept.most / 65535 + 1e-4 * usual) << n;
            const glm::ivec3 c = glm::min(v / 4, cellCount - 1);
            const auto cell = cells[std::size_t(c.x + cellCount.x * (c.y + cellCount.y * c.z))];
            ASSERT_LE(kept.most * double(cell.x), value + 1e-6 * kept.most);
            ASSERT_GE(kept.most * double(cell.y), value - 1e-6 * kept.most);
        });
        EXPECT_GT(kept.most, 2 * usual) << "hardly anything is steeper";
    }
}

TEST_F(GradientTest, CountingInSlicesIsCountingAtOnce) {
    const Field field = uploadVolume(makeWaves(volume::ScalarType::Int16));
    const auto atOnce = jointHistogram(field, gradientRange(field), {40, 30});
    JointCounting counting(field, {40, 30});
    while (!counting.advance(0)) {
    }
    EXPECT_EQ(counting.joint().gradients, atOnce.gradients);
    EXPECT_EQ(counting.joint().values, atOnce.values);
    EXPECT_EQ(counting.joint().counts, atOnce.counts);
    EXPECT_EQ(counting.joint().bins, atOnce.bins);
}

TEST_F(GradientTest, RangesHoldTheLargestAndAlmostAll) {
    const auto volume = makeWaves(volume::ScalarType::Float32);
    const Field field = uploadVolume(volume);
    auto magnitudes = reference::gradientMagnitudes(volume);
    std::sort(magnitudes.begin(), magnitudes.end());
    EXPECT_EQ(fullGradientRange(field).lo, 0);
    EXPECT_NEAR(fullGradientRange(field).hi, magnitudes.back(), 1e-5 * magnitudes.back());
    const double expected = magnitudes[std::size_t(0.999 * double(magnitudes.size()))];
    EXPECT_EQ(gradientRange(field).lo, 0);
    EXPECT_NEAR(gradientRange(field).hi, expected, 0.015 * expected);
}

TEST_F(GradientTest, AGradientThatFewVoxelsHaveIsStillARange) {
    auto volume = phantom::makePhantom({32, 32, 32}, volume::ScalarType::UInt8, [](glm::dvec3) { return 0; });
    EXPECT_EQ(gradientRange(uploadVolume(volume)).hi, 0);
    volume.bytes[16 * 32 * 32 + 16 * 32 + 16] = std::byte(200);
    volume::computeRange(volume);
    EXPECT_NEAR(gradientRange(uploadVolume(volume)).hi, 100, 1e-3);
}

TEST_F(GradientTest, ARampHasItsSlopeInUnitsPerMillimetre) {
    const auto volume = phantom::makePhantom({16, 8, 8}, volume::ScalarType::Int16,
                                             [](glm::dvec3 p) { return 30 * p.x; }, {0.5, 1, 2});
    const auto counts = gradientHistogram(uploadVolume(volume), {0, 120}, 120);
    EXPECT_EQ(counts[60], 14U * 64U); // 30 in half a millimetre
    EXPECT_EQ(counts[30], 2U * 64U) << "at the border the value beyond is the border's";
}

TEST_F(GradientTest, NonFiniteVoxelsAndTheirNeighboursAreLeftOut) {
    auto volume = makeWaves(volume::ScalarType::Float32, {16, 16, 16});
    reinterpret_cast<float*>(volume.bytes.data())[8 * 256 + 8 * 16 + 8] =
        std::numeric_limits<float>::quiet_NaN();
    volume::computeRange(volume);
    const Field field = uploadVolume(volume);
    const Range all = fullGradientRange(field);
    EXPECT_LT(all.hi, 1000);
    EXPECT_EQ(total(gradientHistogram(field, all)), volume.geometry.voxelCount() - 7);
    EXPECT_EQ(total(jointHistogram(field, all).counts), volume.geometry.voxelCount() - 7);
}

TEST_F(GradientTest, TheEdgeOfAFillValueChangesNoRange) {
    for (const bool oblique : {false, true}) {
        auto volume = makeWaves(volume::ScalarType::Float32, {40, 40, 40});
        if (!oblique) {
            volume.geometry.worldFromVoxel = glm::dmat4(1);
        }
        const Field plain = uploadVolume(volume);
        auto* values = reinterpret_cast<float*>(volume.bytes.data());
        for (int i = 0; i < 40 * 40 * 40; ++i) {
            const glm::dvec3 p(i % 40, i / 40 % 40, i / 1600);
            values[i] = glm::distance(p, glm::dvec3(20)) > 18 ? 1e30F : values[i];
        }
        volume::computeRange(volume);
        const Field filled = uploadVolume(volume);
        const Range all = fullGradientRange(filled);
        // Fewer voxels have a gradient, so that the largest of them may be a little smaller.
        EXPECT_GT(all.hi, 0.7 * fullGradientRange(plain).hi);
        EXPECT_LT(all.hi, 1.05 * fullGradientRange(plain).hi);
        EXPECT_NEAR(gradientRange(filled).hi, gradientRange(plain).hi, 0.1 * gradientRange(plain).hi);
        EXPECT_GT(total(gradientHistogram(filled, all)), 20000U) << "of 24,000 in the ball";
    }
}

TEST_F(GradientTest, OneLargeVolumeIsCountedInFull) {
    std::mt19937 random(3);
    const auto volume = phantom::makePhantom(glm::ivec3(256), volume::ScalarType::Int16, [&](glm::dvec3 p) {
        const double noise = double(random() % 64);
        return (glm::distance(p, glm::dvec3(128)) < 90 ? 1000 : 20) + noise;
    });
    const Field field = uploadVolume(volume);
    const Range all = fullGradientRange(field);
    EXPECT_EQ(total(gradientHistogram(field, all)), volume.geometry.voxelCount());
    EXPECT_EQ(total(jointHistogram(field, all).counts), volume.geometry.voxelCount());
}

} // namespace
} // namespace vs::field

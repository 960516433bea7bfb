// SPDX-License-Identifier: Apache-2.0
// Smoothed fields against a plain convolution.
#include "field/smoothed_field.h"
#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "reference/convolution.h"

#include <cmath>
#include <random>

namespace vs::field {
namespace {

using SmoothedFieldTest = test::GlTest;

std::vector<double> valuesOf(const Field& field) {
    std::vector<double> values;
    if (field.texels.format() == gl::Format::R16) {
        for (const std::uint16_t texel : field.texels.downloadAll<std::uint16_t>()) {
            values.push_back(texel / 65535.0 * field.valueScale + field.valueOffset);
        }
    } else {
        for (const float texel : field.texels.downloadAll<float>()) {
            values.push_back(texel);
        }
    }
    return values;
}

volume::Volume noise(volume::ScalarType type, bool hasHoles) {
    std::mt19937 random(3);
    return phantom::makePhantom({37, 29, 71}, type,
                                [&](glm::dvec3) {
                                    const auto draw = random();
                                    return hasHoles && draw % 97 == 0
                                               ? std::nan("")
                                               : double(draw % 4096) -
                                                     (type == volume::ScalarType::UInt8 ? 0 : 1000);
                                },
                                {1, 1.25, 2});
}

void expectConvolved(const volume::Volume& volume, double sigma, double tolerance) {
    const SmoothedField smoothed = smoothField(uploadVolume(volume), sigma);
    const auto expected = reference::convolved(volume, sigma);
    const auto values = valuesOf(smoothed.field);
    ASSERT_EQ(values.size(), expected.size());
    double worst = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(expected[i])) {
            worst = std::max(worst, std::abs(values[i] - expected[i]));
        } else {
            EXPECT_LT(values[i], -1e29) << "voxel " << i << " is outside every range, as before";
        }
    }
    EXPECT_LT(worst, tolerance) << name(volume.type) << " sigma " << sigma;
}

TEST_F(SmoothedFieldTest, ItIsAGaussianConvolution) {
    for (const double sigma : {0.25, 1.0, 2.0}) {
        // Half a step of 65,535 over the values' range, and single precision sums.
        expectConvolved(noise(volume::ScalarType::Int16, false), sigma, 0.05);
        expectConvolved(noise(volume::ScalarType::Float32, false), sigma, 0.005);
    }
}

TEST_F(SmoothedFieldTest, WhatIsNotFiniteStaysAndCountsForNothing) {
    expectConvolved(noise(volume::ScalarType::Float32, true), 1.5, 0.005);
}

TEST_F(SmoothedFieldTest, QuadsHoldTheSameValues) {
    const SmoothedField smoothed = smoothField(uploadVolume(noise(volume::ScalarType::UInt8, false)), 1);
    if (!smoothed.field.quads) {
        GTEST_SKIP() << "there are quads on software renderers only";
    }
    const glm::ivec3 dims = smoothed.field.geometry.dims;
    const auto texels = smoothed.field.texels.downloadAll<std::uint16_t>();
    const auto quads = smoothed.field.quads.buffer().read<std::uint16_t>(4 * texels.size());
    const std::size_t perSlice = std::size_t(dims.x) * std::size_t(dims.y);
    std::vector<std::uint16_t> expected(4 * texels.size());
    for (std::size_t first = 0; first < texels.size(); first += perSlice) {
        quadsOfSlice(std::span<const std::uint16_t>(texels).subspan(first, perSlice), glm::ivec2(dims),
                     expected.data() + 4 * first);
    }
    EXPECT_TRUE(quads == expected);
}

} // namespace
} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
// Scaled whole numbers take no more room on the device than unscaled ones, and keep their values.
#include "field/whole_steps.h"

#include "field/field.h"
#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "property.h"

#include <cmath>
#include <random>

namespace vs::field {
namespace {

using WholeStepsTest = test::GlTest;
using test::below;

const glm::ivec3 kDims(19, 14, 11);

// What a file with these numbers, slope and intercept is read as.
volume::Volume scaledVolume(int lowest, int count, double slope, double intercept) {
    std::mt19937 random(5);
    auto volume = phantom::makePhantom(kDims, volume::ScalarType::Float32, [&](glm::dvec3) {
        return double(float(slope * (lowest + int(random() % unsigned(count))) + intercept));
    });
    volume.details.slope = slope;
    volume.details.intercept = intercept;
    return volume;
}

TEST_F(WholeStepsTest, ScaledNumbersKeepTheirSizeAndTheirValues) {
    test::checkProperty(40, [] {
        const bool isByte = *test::coin();
        const int count = isByte ? 2 + *below(255) : 257 + *below(60000);
        const double slope =
            (*test::coin() ? 1 : -1) * std::pow(10.0, *below(5) - 3) * (1 + *below(100)) / 7.0;
        const auto volume = scaledVolume(*below(2000) - 1000, count, slope, slope * (*below(2000) - 1000));
        const Field field = uploadVolume(volume);
        RC_ASSERT(field.texels.format() == (isByte ? gl::Format::R8 : gl::Format::R16));
        RC_ASSERT(field.step == std::abs(slope));
        RC_ASSERT(field.isIntegral == false);
        const auto bytes = field.texels.download({glm::ivec3(0), kDims});
        const double largest = std::max(std::abs(volume.range.lo), std::abs(volume.range.hi));
        forEachVoxel({glm::ivec3(0), kDims}, [&](glm::ivec3 v, std::size_t i) {
            const int texel = isByte ? std::to_integer<int>(bytes[i])
                                     : int(reinterpret_cast<const std::uint16_t*>(bytes.data())[i]);
            const double value =
                double(texel) / (isByte ? 255 : 65535) * double(field.valueScale) + double(field.valueOffset);
            RC_ASSERT(std::abs(value - volume.at(v)) <= 2e-7 * (largest + double(field.valueScale)));
        });
    });
}

TEST_F(WholeStepsTest, OtherFloatsStayFloats) {
    const auto formatOf = [](const volume::Volume& volume) { return uploadVolume(volume).texels.format(); };
    auto volume = scaledVolume(0, 200, 0.25, 3);
    EXPECT_EQ(formatOf(volume), gl::Format::R8);
    auto unscaled = volume;
    unscaled.details.slope = 1;
    unscaled.details.intercept = 0;
    EXPECT_EQ(formatOf(unscaled), gl::Format::R32F);
    auto another = volume;
    reinterpret_cast<float*>(another.bytes.data())[77] += 0.01F;
    EXPECT_EQ(formatOf(another), gl::Format::R32F) << "one value between two steps";
    auto notANumber = volume;
    reinterpret_cast<float*>(notANumber.bytes.data())[77] = std::nanf("");
    volume::computeRange(notANumber);
    EXPECT_EQ(formatOf(notANumber), gl::Format::R32F);
    EXPECT_EQ(formatOf(scaledVolume(0, 200, 1e-4, 1e5)), gl::Format::R32F) << "steps too small for floats";
    EXPECT_EQ(formatOf(scaledVolume(0, 200000, 0.5, 0)), gl::Format::R32F) << "too many steps";
}

} // namespace
} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace vs::sculpt {
namespace {

double sumOf(const AxisFootprint& axis) {
    double sum = axis.taps[0];
    for (int k = 1; k <= axis.reach; ++k) {
        sum += 2.0 * double(axis.taps[std::size_t(k)]);
    }
    return sum;
}

// Variance of deposit and taps together: B-splines of degree 1, 2, 3 have 1/6, 1/4, 1/3.
double varianceOf(const AxisFootprint& axis) {
    double sum = (axis.degree + 1) / 12.0;
    for (int k = 1; k <= axis.reach; ++k) {
        sum += 2.0 * k * k * double(axis.taps[std::size_t(k)]);
    }
    return sum;
}

TEST(Footprint, TapsSumToOneAndHaveTheGaussiansWidth) {
    for (const int radius : {2, 3, 4}) {
        for (const AxisFootprint& axis : fitFootprint(radius).axes) {
            EXPECT_NEAR(sumOf(axis), 1, 1e-6) << radius;
            // Cutting the Gaussian at 3 sigma takes 1 to 3 % of its width.
            EXPECT_NEAR(std::sqrt(varianceOf(axis)), radius / 3.0, 0.05 * radius / 3.0) << radius;
        }
    }
}

TEST(Footprint, FollowsTheSpacingOfEachAxis) {
    const Footprint footprint = fitFootprint(3, {0.5, 1.0, 0.6});
    EXPECT_DOUBLE_EQ(footprint.sigmaVoxels.x, 1.0);
    EXPECT_DOUBLE_EQ(footprint.sigmaVoxels.y, 0.5);
    EXPECT_NEAR(footprint.sigmaVoxels.z, 1 / 1.2, 1e-12);
    EXPECT_NEAR(varianceOf(footprint.axes[1]), 0.25, 0.02);
    EXPECT_EQ(fitFootprint(2, {1, 1, 5}).axes[2].degree, 1);
    EXPECT_EQ(fitFootprint(2, {1, 1, 5}).reachVoxels().z, 1);
}

TEST(Footprint, CoarseAxesAreSmoothWhereAskedFor) {
    FootprintShape shape;
    shape.isSmoothWhereCoarse = true;
    EXPECT_EQ(fitFootprint(shape, {1, 1, 3}).axes[2].degree, 2);
    EXPECT_EQ(fitFootprint(shape, {1, 1, 3}).axes[2].reach, 0);
    EXPECT_EQ(fitFootprint(shape, {1, 1, 3}).axes[0].taps, fitFootprint(3).axes[0].taps);
}

TEST(Footprint, ReferenceWeightsAreANormalisedGaussian) {
    const ReferenceWeights weights = referenceWeights(1, 0.25);
    EXPECT_EQ(weights.halfWidth, 3);
    EXPECT_NEAR(std::accumulate(weights.weights.begin(), weights.weights.end(), 0.0), 1, 1e-12);
    // Voxels 0 and 1 are 0.25 and 0.75 away.
    EXPECT_NEAR(weights.weights[2] / weights.weights[3], std::exp(0.5 * (0.75 * 0.75 - 0.25 * 0.25)), 1e-12);
}

TEST(Footprint, EllipsoidsHaveTheirOwnWidthAlongEachAxis) {
    FootprintShape shape;
    shape.kind = FootprintKind::Ellipsoid;
    shape.sigmaSteps = {1.3, 0.7, 1.0};
    const Footprint footprint = fitFootprint(shape, {1, 1, 2});
    EXPECT_DOUBLE_EQ(footprint.sigmaVoxels.z, 0.5);
    EXPECT_NEAR(std::sqrt(varianceOf(footprint.axes[0])), 1.3, 0.06);
    EXPECT_NEAR(std::sqrt(varianceOf(footprint.axes[1])), 0.7, 0.03);
    shape.sigmaSteps = glm::dvec3(1);
    EXPECT_EQ(fitFootprint(shape).axes[0].taps, fitFootprint(3).axes[0].taps);
}

TEST(Footprint, CubesAreFlatInsideAndHalfAtTheirFaces) {
    for (const int radius : {2, 3, 4}) {
        FootprintShape shape;
        shape.kind = FootprintKind::Cube;
        shape.radius = radius;
        const Footprint footprint = fitFootprint(shape);
        EXPECT_NEAR(sumOf(footprint.axes[0]), 1, 1e-6);
        EXPECT_EQ(footprint.axes[0].reach, radius);
        EXPECT_FLOAT_EQ(footprint.axes[0].taps[0], 1.0F / float(2 * radius));
        EXPECT_FLOAT_EQ(footprint.axes[0].taps[std::size_t(radius)], 0.5F / float(2 * radius));
        // Coarser slices: half of a box of 2R / 3 voxels.
        EXPECT_NEAR(sumOf(fitFootprint(shape, {1, 1, 3}).axes[2]), 1, 1e-6);
        for (const double offset : {0.0, 0.3, 0.9}) {
            const auto weights = cubeReferenceWeights(radius, offset);
            double sum = 0;
            double centre = 0;
            for (int n = 0; n < 2 * weights.halfWidth; ++n) {
                sum += weights.weights[std::size_t(n)];
                centre += (n + 1 - weights.halfWidth) * weights.weights[std::size_t(n)];
            }
            EXPECT_NEAR(sum, 1, 1e-12);
            EXPECT_NEAR(centre, offset, 1e-12);
        }
    }
}

} // namespace
} // namespace vs::sculpt

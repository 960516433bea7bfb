// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace vs::sculpt {
namespace {

double areaOf(const MaskRaster& mask) {
    return std::accumulate(mask.values.begin(), mask.values.end(), 0.0) * mask.pitch * mask.pitch;
}

// Bilinear between elements.
double sampleAt(const MaskRaster& mask, glm::dvec2 p) {
    const glm::dvec2 e = (p - mask.origin) / mask.pitch;
    const glm::ivec2 c(glm::floor(e));
    const glm::dvec2 f = e - glm::dvec2(c);
    return (1 - f.y) * ((1 - f.x) * mask.at(c.x, c.y) + f.x * mask.at(c.x + 1, c.y)) +
           f.y * ((1 - f.x) * mask.at(c.x, c.y + 1) + f.x * mask.at(c.x + 1, c.y + 1));
}

TEST(Mask, HalfLiesOnTheOutlineAndTheEdgeIsAboutAnElementWide) {
    for (const double pitch : {1.0, 0.5, 2.0}) {
        // A square turned by half a radian: its sides cross the raster at all places.
        Outline outline;
        for (int n = 0; n < 4; ++n) {
            const double angle = 0.5 + n * std::numbers::pi / 2;
            outline.push_back(glm::dvec2(50, 40) + 30.0 * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        const MaskRaster mask = rasterize(outline, pitch);
        const glm::dvec2 along = glm::normalize(outline[1] - outline[0]);
        const glm::dvec2 inwards(-along.y, along.x);
        double mean = 0;
        for (double t = 10; t < 32; t += 0.37) {
            const glm::dvec2 on = outline[0] + t * along;
            mean += sampleAt(mask, on) / 60;
            EXPECT_NEAR(sampleAt(mask, on), 0.5, 0.06);
            EXPECT_GT(sampleAt(mask, on + 1.1 * pitch * inwards), 0.9);
            EXPECT_LT(sampleAt(mask, on - 1.1 * pitch * inwards), 0.1);
            EXPECT_GT(sampleAt(mask, on + 2.9 * pitch * inwards), 0.999);
        }
        EXPECT_NEAR(mean, 0.5, 0.01);
    }
}

TEST(Mask, KeepsTheArea) {
    EXPECT_NEAR(areaOf(rasterize(ellipseOutline({40.3, 30.7}, {25, 14}), 1)), std::numbers::pi * 25 * 14, 2);
    EXPECT_NEAR(areaOf(rasterize(rectangleOutline({0.2, 0.3}, {10.7, 5.1}), 0.5)), 10.5 * 4.8, 0.3);
    for (const auto sampling : {Sampling::None, Sampling::Uniform}) {
        const MaskFilter filter{sampling, Reconstruction::Box, 10, 1};
        EXPECT_NEAR(areaOf(rasterize(circleOutline({20.3, 20.4}, 15), 1, filter)), std::numbers::pi * 225, 8);
    }
}

TEST(Mask, UnfilteredIsBinaryAndTestsElementCentres) {
    MaskFilter filter;
    filter.sampling = Sampling::None;
    const MaskRaster mask = rasterize(rectangleOutline({0.5, 0.5}, {3.5, 2.5}), 1, filter);
    EXPECT_EQ(std::count(mask.values.begin(), mask.values.end(), 1.0F), 6);
    EXPECT_EQ(std::count(mask.values.begin(), mask.values.end(), 0.0F),
              std::ptrdiff_t(mask.values.size()) - 6);
}

TEST(Mask, EvenOddLeavesTheMiddleOfARingOpen) {
    // One stroke round twice, the second time inside: a self-crossing outline.
    Outline ring = circleOutline({30, 30}, 20);
    const Outline inner = circleOutline({30, 30}, 10);
    ring.push_back(ring.front());
    ring.insert(ring.end(), inner.begin(), inner.end());
    ring.push_back(inner.front());
    const MaskRaster mask = rasterize(ring, 1);
    EXPECT_LT(sampleAt(mask, {30, 30}), 1e-6);
    EXPECT_GT(sampleAt(mask, {30, 45}), 1 - 1e-6);
    EXPECT_NEAR(areaOf(mask), std::numbers::pi * 300, 4);
}

TEST(Mask, SameOutlineSameMaskAndMovingByElementsMovesIt) {
    const auto a = rasterize(circleOutline({30, 30}, 12.3), 1);
    EXPECT_EQ(a.values, rasterize(circleOutline({30, 30}, 12.3), 1).values);
    const auto moved = rasterize(circleOutline({37, 28}, 12.3), 1);
    EXPECT_EQ(moved.size, a.size);
    EXPECT_EQ(moved.origin - a.origin, glm::dvec2(7, -2));
    MaskFilter other;
    other.seed = 2;
    EXPECT_NE(a.values, rasterize(circleOutline({30, 30}, 12.3), 1, other).values);
}

TEST(Mask, ARimOfZerosSurroundsIt) {
    const auto mask =
        rasterize(freeFormOutline(std::vector<glm::dvec2>{{3, 4}, {3, 4}, {20.5, 7}, {11, 18.2}}), 1);
    for (int i = 0; i < mask.size.x; ++i) {
        EXPECT_EQ(mask.at(i, 0), 0.0F);
        EXPECT_EQ(mask.at(i, mask.size.y - 1), 0.0F);
    }
    for (int j = 0; j < mask.size.y; ++j) {
        EXPECT_EQ(mask.at(0, j), 0.0F);
        EXPECT_EQ(mask.at(mask.size.x - 1, j), 0.0F);
    }
}

TEST(Mask, NothingIsNoMaskAndTooMuchIsRefused) {
    EXPECT_TRUE(rasterize({}, 1).values.empty());
    EXPECT_TRUE(rasterize(Outline{{1, 1}, {5, 5}}, 1).values.empty());
    EXPECT_THROW(rasterize(circleOutline({0, 0}, 1e6), 1), Error);
}

TEST(Mask, CubicBSplineIsAPartitionOfUnity) {
    for (double x = 0; x < 1; x += 0.1) {
        EXPECT_NEAR(cubicBSpline(x + 1) + cubicBSpline(x) + cubicBSpline(x - 1) + cubicBSpline(x - 2), 1,
                    1e-12);
    }
    EXPECT_NEAR(cubicBSpline(0), 4.0 / 6, 1e-12);
    EXPECT_NEAR(cubicBSpline(1), 1.0 / 6, 1e-12);
}

} // namespace
} // namespace vs::sculpt

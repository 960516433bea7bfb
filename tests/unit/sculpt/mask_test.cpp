// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/mask.h"

#include "base/error.h"
#include "sculpt/mask/mask_image.h"

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

TEST(Mask, EveryFilterAtEveryWidthKeepsHalfOnStraightEdges) {
    // A rectangle turned by 0.4 radians, large enough for the widest filter.
    const glm::dvec2 along(std::cos(0.4), std::sin(0.4));
    const glm::dvec2 aside(-along.y, along.x);
    Outline outline;
    for (const glm::dvec2 corner : {glm::dvec2(-20, -15), {20, -15}, {20, 15}, {-20, 15}}) {
        outline.push_back(corner.x * along + corner.y * aside);
    }
    for (std::size_t kind = 0; kind < kReconstructions.size(); ++kind) {
        for (const Sampling sampling : {Sampling::Uniform, Sampling::Jittered}) {
            for (const int width : {10, 11, 17, 20, 40, 50, 100}) {
                const MaskFilter filter{sampling, Reconstruction(kind), width, 3};
                const MaskRaster mask = rasterize(outline, 1, filter);
                double mean = 0;
                int count = 0;
                for (double t = -12; t < 12; t += 0.31) {
                    mean += sampleAt(mask, t * along - 15.0 * aside);
                    ++count;
                }
                EXPECT_NEAR(mean / count, 0.5, 0.012) << kReconstructions[kind] << " " << width;
                EXPECT_NEAR(sampleAt(mask, {0, 0}), 1, 1e-5) << kReconstructions[kind] << " " << width;
                EXPECT_LE(*std::max_element(mask.values.begin(), mask.values.end()), 1.0F);
                EXPECT_GE(*std::min_element(mask.values.begin(), mask.values.end()), 0.0F);
            }
        }
    }
}

TEST(Mask, WiderFiltersMakeWiderEdges) {
    const auto grey = [](Reconstruction kind, int width) {
        const auto mask = rasterize(circleOutline({0, 0}, 20), 1, {Sampling::Uniform, kind, width, 1});
        return std::count_if(mask.values.begin(), mask.values.end(),
                             [](float v) { return v > 0.02F && v < 0.98F; });
    };
    for (std::size_t kind = 0; kind < kReconstructions.size(); ++kind) {
        EXPECT_LT(grey(Reconstruction(kind), 20), grey(Reconstruction(kind), 50)) << kReconstructions[kind];
        EXPECT_LT(grey(Reconstruction(kind), 50), grey(Reconstruction(kind), 100)) << kReconstructions[kind];
    }
}

TEST(Mask, ReconstructionWeightsAreSymmetricAndSumToOne) {
    for (std::size_t kind = 0; kind < kReconstructions.size(); ++kind) {
        for (int width = 1; width <= 100; ++width) {
            const auto weights = reconstructionWeights(Reconstruction(kind), width);
            EXPECT_EQ(weights.size() % 2, 0U);
            EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-5);
            for (std::size_t n = 0; n < weights.size(); ++n) {
                EXPECT_FLOAT_EQ(weights[n], weights[weights.size() - 1 - n]);
            }
        }
    }
    // The tent of two elements reaches 0.1 of its peak's height at 0.9 of its half-width.
    const auto tent = reconstructionWeights(Reconstruction::Tent, 20);
    EXPECT_NEAR(tent[0] / tent[9], 0.05 / 0.95, 1e-5);
    // Catmull-Rom interpolates: nothing at whole intervals, negative beyond the first.
    EXPECT_NEAR(mitchellNetravali(1, 0, 0.5), 0, 1e-12);
    EXPECT_LT(mitchellNetravali(1.5, 0, 0.5), -0.05);
    EXPECT_NEAR(mitchellNetravali(0, 1.0 / 3, 1.0 / 3), 8.0 / 9, 1e-12);
}

TEST(Mask, PolygonSmoothIsTheExactArea) {
    MaskFilter filter;
    filter.sampling = Sampling::PolygonSmooth;
    const Outline triangle{{1.3, 0.6}, {9.1, 3.2}, {4.4, 8.8}};
    const glm::dvec2 a = triangle[1] - triangle[0];
    const glm::dvec2 b = triangle[2] - triangle[0];
    EXPECT_NEAR(areaOf(rasterize(triangle, 0.5, filter)), 0.5 * (a.x * b.y - a.y * b.x), 1e-5);
    // A square's own edges: half elements, and a quarter at its corner.
    const MaskRaster square = rasterize(rectangleOutline({0, 0}, {4, 4}), 1, filter);
    const glm::ivec2 zero(glm::round(-square.origin));
    EXPECT_FLOAT_EQ(square.at(zero.x, zero.y), 0.25F);
    EXPECT_FLOAT_EQ(square.at(zero.x + 2, zero.y), 0.5F);
    EXPECT_FLOAT_EQ(square.at(zero.x + 2, zero.y + 2), 1);
    // A bow tie: its lobes are inside, and it crosses itself in the middle of an element.
    const Outline bow{{0.2, 0.2}, {8.2, 8.2}, {8.2, 0.2}, {0.2, 8.2}};
    EXPECT_NEAR(areaOf(rasterize(bow, 1, filter)), 32, 1e-4);
    // Each element against many points in its square.
    const Outline star = starOutline({10, 10}, 8, 3, 5);
    const MaskRaster exact = rasterize(star, 1, filter);
    const MaskRaster many = rasterize(star, 1, {Sampling::Jittered, Reconstruction::Box, 10, 1});
    for (int j = 2; j < 19; ++j) {
        for (int i = 2; i < 19; ++i) {
            const glm::ivec2 at(glm::round(glm::dvec2(i, j) - exact.origin));
            const glm::ivec2 atMany(glm::round(glm::dvec2(i, j) - many.origin));
            EXPECT_NEAR(exact.at(at.x, at.y), many.at(atMany.x, atMany.y), 0.05) << i << " " << j;
        }
    }
}

TEST(Mask, StarsHaveTheirTipsAndArea) {
    const Outline star = starOutline({0, 0}, 10, 4, 5);
    ASSERT_EQ(star.size(), 10U);
    EXPECT_LT(glm::length(star[0] - glm::dvec2(0, 10)), 1e-12);
    EXPECT_NEAR(glm::length(star[1]), 4, 1e-12);
    // Ten triangles with sides 10 and 4 and the angle pi / 5 between them.
    EXPECT_NEAR(areaOf(rasterize(star, 0.25)), 10 * 0.5 * 10 * 4 * std::sin(std::numbers::pi / 5), 1);
}

TEST(Mask, SubdivisionConvergesToItsSplines) {
    const Outline square = rectangleOutline({-1, -1}, {1, 1});
    for (const Subdivision scheme : {Subdivision::CubicBSpline, Subdivision::Chaikin}) {
        EXPECT_EQ(subdivide(square, scheme, 0), square);
        EXPECT_EQ(subdivide(square, scheme, 3).size(), 32U);
    }
    // The limit of a control point P of the cubic is (A + 4 P + B) / 6, of a side of the quadratic its
    // middle.
    const Outline cubic = subdivide(square, Subdivision::CubicBSpline, 8);
    EXPECT_LT(glm::length(cubic[0] - glm::dvec2(-2.0 / 3, -2.0 / 3)), 1e-4);
    EXPECT_LT(glm::length(cubic[128] - glm::dvec2(0, -11.0 / 12)), 1e-4);
    double least = 10;
    for (const glm::dvec2& p : subdivide(square, Subdivision::Chaikin, 8)) {
        least = std::min(least, glm::length(p - glm::dvec2(0, -1)));
    }
    EXPECT_LT(least, 0.005);
    EXPECT_THROW(subdivide(square, Subdivision::Chaikin, 40), Error);
}

TEST(Mask, PicturesAreMasks) {
    // Bright upper left quarter with one grey pixel, 8 x 4 pixels.
    image::Image picture(8, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) {
            const auto value = std::uint8_t(x < 4 && y < 2 ? 255 : 0);
            std::uint8_t* pixel = picture.pixel(x, y);
            pixel[0] = pixel[1] = pixel[2] = value;
            pixel[3] = 255;
        }
    }
    std::fill_n(picture.pixel(4, 1), 3, std::uint8_t(102));
    const MaskRaster mask = maskFromImage(picture, 16, 0.5); // pixels of 2 units are not split
    EXPECT_EQ(mask.pitch, 2);
    EXPECT_EQ(mask.size, glm::ivec2(10, 6));
    EXPECT_FLOAT_EQ(float(sampleAt(mask, {-7, 3})), 1); // the picture's top is up
    EXPECT_FLOAT_EQ(float(sampleAt(mask, {-7, -3})), 0);
    EXPECT_FLOAT_EQ(float(sampleAt(mask, {1, 1})), 0.4F);
    EXPECT_NEAR(areaOf(mask), 8.4 * 4, 1e-4);
    const MaskRaster coarse = maskFromImage(picture, 4, 1); // pixels of half a unit in blocks of four
    EXPECT_EQ(coarse.pitch, 1);
    EXPECT_EQ(coarse.size, glm::ivec2(6, 4));
    EXPECT_NEAR(areaOf(coarse), 8.4 / 4, 1e-5);
    picture.pixel(7, 3)[3] = 51; // now alpha tells
    EXPECT_NEAR(areaOf(maskFromImage(picture, 8, 0.5)), 31.2, 1e-4);
    EXPECT_THROW(maskFromImage(image::Image(), 8, 0.5), Error);
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

// SPDX-License-Identifier: Apache-2.0
#include "reference/radiation.h"

#include "gpu/gl_test.h"
#include "sculpt/mask/mask.h"
#include "sculpt/path/path.h"
#include "sculpt/radiation/radiation.h"
#include "sculpt/radiation/sweep.h"
#include "sculpt/radiation/tool_points.h"
#include "surface_makers.h"

#include <cmath>
#include <random>

namespace vs::sculpt {
namespace {

class RadiationTest : public test::GlTest {
protected:
    static std::vector<float> radiate(const std::vector<glm::vec4>& points, glm::ivec3 dims,
                                      const Footprint& footprint, int times = 1) {
        Radiator radiator;
        gl::Buffer buffer(points.size() * sizeof(glm::vec4), "points");
        buffer.write(std::span(points));
        radiator.begin({glm::ivec3(-4), dims + 4}, dims, footprint);
        for (int n = 0; n < times; ++n) {
            radiator.deposit(buffer, points.size());
        }
        radiator.finish();
        return radiator.download({glm::ivec3(0), dims});
    }

    // The points of a mask swept along a path, as the program makes them.
    static std::vector<glm::vec4> sweptPoints(const MaskRaster& mask, const std::vector<PathPiece>& path) {
        std::vector<glm::vec4> all;
        PointGenerator generator;
        for (const PathPiece& piece : path) {
            generator.generate(sweepPiece(mask, piece), [&](const gl::Buffer& points, std::size_t count) {
                const auto some = points.read<glm::vec4>(count);
                all.insert(all.end(), some.begin(), some.end());
            });
        }
        return all;
    }

    static std::vector<PathPiece> line(glm::dvec3 from, glm::dvec3 to) {
        return polylinePath(std::vector<glm::dvec3>{from, to});
    }
};

std::size_t indexOf(glm::ivec3 v, glm::ivec3 dims) {
    return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
           std::size_t(v.x);
}

TEST_F(RadiationTest, ASinglePointKeepsItsEnergyCentreAndPeak) {
    const glm::ivec3 dims(17, 18, 19);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> offset(7.5F, 9.5F);
    for (int n = 0; n < 20; ++n) {
        const glm::vec4 point(offset(random), offset(random), offset(random), 1);
        const Footprint footprint = fitFootprint(3);
        const auto fast = radiate({point}, dims, footprint);
        const auto exact = reference::radiate(std::vector{point}, dims, footprint.sigmaVoxels);
        double energy = 0;
        glm::dvec3 centre(0);
        float peak = 0;
        float exactPeak = 0;
        for (int z = 0; z < dims.z; ++z) {
            for (int y = 0; y < dims.y; ++y) {
                for (int x = 0; x < dims.x; ++x) {
                    const float e = fast[indexOf({x, y, z}, dims)];
                    energy += e;
                    centre += double(e) * glm::dvec3(x, y, z);
                    peak = std::max(peak, e);
                    exactPeak = std::max(exactPeak, exact[indexOf({x, y, z}, dims)]);
                }
            }
        }
        EXPECT_NEAR(energy, 1, 1e-4);
        EXPECT_LT(glm::length(centre / energy - glm::dvec3(point)), 0.01);
        EXPECT_NEAR(peak / exactPeak, 1, 0.03);
    }
}

TEST_F(RadiationTest, DenseSweptMasksMatchTheReference) {
    const glm::ivec3 dims(48, 44, 40);
    const MaskRaster mask = rasterize(ellipseOutline({0, 0}, {13, 9}), kSweepPitch);
    const auto points = sweptPoints(mask, line({14, 15, 9}, {30, 26, 29}));
    ASSERT_GT(points.size(), 10000U);
    for (const int radius : {2, 3, 4}) {
        const Footprint footprint = fitFootprint(radius);
        const auto fast = radiate(points, dims, footprint);
        const auto exact = reference::radiate(points, dims, footprint.sigmaVoxels);
        double worst = 0;
        double worstInside = 0;
        for (std::size_t n = 0; n < fast.size(); ++n) {
            worst = std::max(
                worst, std::abs(std::clamp<double>(fast[n], 0, 1) - std::clamp<double>(exact[n], 0, 1)));
            if (exact[n] > 0.999) {
                worstInside = std::max(worstInside, std::abs(double(fast[n]) - exact[n]));
            }
        }
        // What the fitted taps leave: 5e-3 for the narrowest Gaussian, 1.6e-3 and less for the others.
        EXPECT_LE(worst, radius == 2 ? 7e-3 : 2.5e-3) << radius;
        EXPECT_LE(worstInside, radius == 2 ? 7e-3 : 2.5e-3) << radius;
    }
}

TEST_F(RadiationTest, TheOrderOfPointsDoesNotMatter) {
    const glm::ivec3 dims(40);
    auto points =
        sweptPoints(rasterize(circleOutline({0, 0}, 8), kSweepPitch), line({12, 14, 10}, {25, 20, 28}));
    const auto first = radiate(points, dims, fitFootprint(3));
    std::shuffle(points.begin(), points.end(), std::mt19937(5));
    EXPECT_EQ(radiate(points, dims, fitFootprint(3)), first);
}

TEST_F(RadiationTest, PiledUpEnergySaturatesInsteadOfWrapping) {
    const glm::ivec3 dims(16);
    // So often the largest energy that even the corners of the deposit, with 1/512 of it, pass the limit.
    const std::vector<glm::vec4> points(20000, glm::vec4(8, 8, 8, 1e6F));
    const auto once = radiate(points, dims, fitFootprint(3));
    const auto twice = radiate(points, dims, fitFootprint(3), 2);
    EXPECT_GT(once[indexOf({8, 8, 8}, dims)], 10);
    EXPECT_EQ(once, twice);
}

TEST_F(RadiationTest, SpreadIsIsotropicInMillimetres) {
    // Slices 2 mm apart: a ball of points in millimetres must stay a ball. Second moments tell.
    const glm::dvec3 spacing(1, 1, 1.5);
    const Footprint footprint = fitFootprint(4, spacing);
    const glm::ivec3 dims(33, 33, 25);
    const auto fast = radiate({glm::vec4(16.3F, 16.1F, 12.4F, 1)}, dims, footprint);
    glm::dvec3 variance(0);
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const glm::dvec3 mm = (glm::dvec3(x, y, z) - glm::dvec3(16.3, 16.1, 12.4)) * spacing;
                variance += double(fast[indexOf({x, y, z}, dims)]) * mm * mm;
            }
        }
    }
    EXPECT_NEAR(std::sqrt(variance.x), 4 / 3.0, 0.03);
    EXPECT_NEAR(std::sqrt(variance.y), 4 / 3.0, 0.03);
    EXPECT_NEAR(std::sqrt(variance.z), 4 / 3.0, 0.08); // fewer taps stand for the truncated Gaussian
}

TEST_F(RadiationTest, CoarseSlicesTakeTheNarrowestSpread) {
    // 3 mm slices: sigma is a third of a slice, narrower than any spline; energy and centre must still be
    // right.
    const Footprint footprint = fitFootprint(3, {1, 1, 3});
    EXPECT_EQ(footprint.axes[2].degree, 1);
    const glm::ivec3 dims(20, 20, 12);
    const auto fast = radiate({glm::vec4(9.7F, 10.2F, 5.3F, 1)}, dims, footprint);
    double energy = 0;
    double centre = 0;
    for (int z = 0; z < dims.z; ++z) {
        for (int n = 0; n < 400; ++n) {
            energy += fast[std::size_t(z) * 400 + std::size_t(n)];
            centre += z * double(fast[std::size_t(z) * 400 + std::size_t(n)]);
        }
    }
    EXPECT_NEAR(energy, 1, 1e-4);
    EXPECT_NEAR(centre, 5.3, 0.01);
}

TEST_F(RadiationTest, AnObliqueEllipseHasItsWallsWhereTheyBelong) {
    const glm::ivec3 dims(104, 100, 96);
    const glm::dvec3 from(40, 42, 22);
    const glm::dvec3 to(60, 56, 74);
    const auto path = line(from, to);
    const auto sweep = [&](double pitch) {
        Radiator radiator;
        PointGenerator generator;
        sweepMask(radiator, generator, rasterize(ellipseOutline({0, 0}, {30, 20}), pitch), path, dims,
                  fitFootprint(3));
        return radiator.download({glm::ivec3(0), dims});
    };
    const auto e = sweep(kSweepPitch);
    double squared = 0;
    int count = 0;
    for (const double along : {0.3, 0.45, 0.6, 0.7}) {
        for (int n = 0; n < 64; ++n) {
            const double angle = 2 * 3.14159265358979 * n / 64;
            const glm::dvec2 edge(30 * std::cos(angle), 20 * std::sin(angle));
            const glm::dvec3 centre = glm::mix(from, to, along);
            const glm::dvec3 way = edge.x * path[0].from.x + edge.y * path[0].from.y;
            const double found = test::crossingOf(e, dims, centre, glm::normalize(way), glm::length(way) + 4);
            // Distance across the wall, not along the ray from the centre.
            const glm::dvec2 normal = glm::normalize(edge / glm::dvec2(900, 400));
            const double off = (found - glm::length(way)) * glm::dot(normal, glm::normalize(edge));
            squared += off * off;
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(squared / count), 0.1);
    // Ends: flat, exactly at the path's ends.
    const glm::dvec3 way = glm::normalize(to - from);
    EXPECT_NEAR(test::crossingOf(e, dims, glm::mix(from, to, 0.5), way, 40), 0.5 * glm::length(to - from),
                0.05);
    EXPECT_NEAR(test::crossingOf(e, dims, glm::mix(from, to, 0.5), -way, 40), 0.5 * glm::length(to - from),
                0.05);
    // Twice as many elements: the same solid.
    const auto dense = sweep(kSweepPitch / 2);
    float worst = 0;
    for (std::size_t n = 0; n < e.size(); ++n) {
        worst = std::max(worst, std::abs(std::clamp(e[n], 0.0F, 1.0F) - std::clamp(dense[n], 0.0F, 1.0F)));
    }
    EXPECT_LE(worst, 0.02);
}

TEST_F(RadiationTest, APathWithACornerHasNoHole) {
    const glm::ivec3 dims(64, 64, 40);
    Radiator radiator;
    PointGenerator generator;
    const std::vector<glm::dvec3> corners{{12, 32, 20}, {34, 32, 20}, {34, 54, 20}};
    sweepMask(radiator, generator, rasterize(circleOutline({0, 0}, 8), kSweepPitch), polylinePath(corners),
              dims, fitFootprint(3));
    const auto e = radiator.download({glm::ivec3(0), dims});
    for (int t = 0; t <= 20; ++t) {
        EXPECT_GT(e[indexOf({13 + t, 32, 20}, dims)], 0.8) << t;
        EXPECT_GT(e[indexOf({34, 32 + t, 20}, dims)], 0.8) << t;
    }
    EXPECT_GT(e[indexOf({34 + 4, 32 - 4, 20}, dims)], 0.9); // the outer side of the bend is filled round
    EXPECT_LT(e[indexOf({34 + 8, 32 - 8, 20}, dims)], 0.1);
}

TEST_F(RadiationTest, PointsOutsideTheGridReachIn) {
    const glm::ivec3 dims(16);
    const Footprint footprint = fitFootprint(3);
    const std::vector<glm::vec4> points{{-1.3F, 8, 8, 1}, {8, 16.2F, 7.6F, 1}, {300, 4, 4, 1}, {8, 8, -9, 1}};
    const auto fast = radiate(points, dims, footprint);
    const auto exact = reference::radiate(points, dims, footprint.sigmaVoxels);
    for (std::size_t n = 0; n < fast.size(); ++n) {
        EXPECT_NEAR(fast[n], exact[n], 4e-3); // a single point's fit
    }
}

TEST_F(RadiationTest, ReusedScratchHoldsNothingOfTheLastUse) {
    const glm::ivec3 dims(64);
    Radiator radiator;
    PointGenerator generator;
    const MaskRaster mask = rasterize(circleOutline({0, 0}, 6), kSweepPitch);
    const auto run = [&](glm::dvec3 from, glm::dvec3 to) {
        sweepMask(radiator, generator, mask, line(from, to), dims, fitFootprint(3));
        return radiator.download({glm::ivec3(0), dims});
    };
    const auto first = run({20, 20, 20}, {20, 20, 34});
    run({40, 44, 12}, {28, 20, 50});
    EXPECT_EQ(run({20, 20, 20}, {20, 20, 34}), first);
    // A use that was never finished leaves nothing either.
    radiator.begin({glm::ivec3(0), dims}, dims, fitFootprint(3));
    gl::Buffer points(sizeof(glm::vec4), "point");
    points.writeValue(glm::vec4(21, 21, 21, 1));
    radiator.deposit(points, 1);
    EXPECT_EQ(run({20, 20, 20}, {20, 20, 34}), first);
    // Nothing deposited, nothing touched.
    radiator.begin({glm::ivec3(0), dims}, dims, fitFootprint(3));
    EXPECT_TRUE(radiator.finish().isEmpty());
}

} // namespace
} // namespace vs::sculpt

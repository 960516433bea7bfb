// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "reference/footprints.h"
#include "reference/radiation.h"
#include "reference/solids.h"
#include "sculpt/radiation/projection.h"
#include "sculpt/radiation/raw_radiation.h"
#include "sculpt/radiation/sweep.h"
#include "sculpt/sculpture/precision.h"
#include "surface_makers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vs::sculpt {
namespace {

class SweepMethods : public test::GlTest {
protected:
    static std::vector<PathPiece> line(glm::dvec3 from, glm::dvec3 to) {
        return polylinePath(std::vector<glm::dvec3>{from, to});
    }
    // The points that a sweep makes, and what the fast radiation makes of them.
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
    static std::vector<float> radiate(const std::vector<glm::vec4>& points, glm::ivec3 dims,
                                      const Footprint& footprint) {
        Radiator radiator;
        gl::Buffer buffer(points.size() * sizeof(glm::vec4), "points");
        buffer.write(std::span(points));
        radiator.begin({glm::ivec3(-4), dims + 4}, dims, footprint);
        radiator.deposit(buffer, points.size());
        radiator.finish();
        return radiator.download({glm::ivec3(0), dims});
    }
    static float largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
        float worst = 0;
        for (std::size_t n = 0; n < a.size(); ++n) {
            worst = std::max(worst, std::abs(a[n] - b[n]));
        }
        return worst;
    }
    static float at(const std::vector<float>& values, glm::ivec3 dims, glm::ivec3 v) {
        return values[(std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
                      std::size_t(v.x)];
    }
};

TEST_F(SweepMethods, CubesAndEllipsoidsMatchDirectSplatting) {
    const glm::ivec3 dims(40, 38, 36);
    const auto points =
        sweptPoints(rasterize(ellipseOutline({0, 0}, {9, 6}), kSweepPitch), line({13, 14, 10}, {25, 22, 24}));
    for (const int radius : {2, 3, 4}) {
        FootprintShape cube;
        cube.kind = FootprintKind::Cube;
        cube.radius = radius;
        EXPECT_LT(largestDifference(radiate(points, dims, fitFootprint(cube)),
                                    reference::radiateCube(points, dims, glm::dvec3(radius))),
                  1e-4F)
            << radius;
        const glm::dvec3 spacing(1, 1.5, 1);
        EXPECT_LT(largestDifference(radiate(points, dims, fitFootprint(cube, spacing)),
                                    reference::radiateCube(points, dims, double(radius) / spacing)),
                  1e-4F)
            << radius;
        // A single point: flat in its middle, as far as the box reaches.
        const auto single = radiate({{20, 19, 18, 1}}, dims, fitFootprint(cube));
        EXPECT_FLOAT_EQ(at(single, dims, {20, 19, 18}), at(single, dims, {20 + radius - 1, 19, 18}));
        EXPECT_NEAR(at(single, dims, {20 + radius, 19, 18}), 0.5F * at(single, dims, {20, 19, 18}), 1e-6F);
        EXPECT_EQ(at(single, dims, {20 + radius + 1, 19, 18}), 0);
    }
    FootprintShape ellipsoid;
    ellipsoid.kind = FootprintKind::Ellipsoid;
    ellipsoid.sigmaSteps = {4.0 / 3, 1.0, 0.8};
    const Footprint footprint = fitFootprint(ellipsoid);
    EXPECT_LT(largestDifference(radiate(points, dims, footprint),
                                reference::radiate(points, dims, ellipsoid.sigmaSteps)),
              7e-3F);
}

TEST_F(SweepMethods, RawPlanesGrowThickerWithTheRadiusAndFollowTheirFormula) {
    // A mask standing still, one radiation: a plane of strength 0.1 an element, spread by a Gaussian across
    // it (thesis, section 3.6.1).
    const glm::ivec3 dims(48);
    const double pitch = 0.1;
    const MaskRaster mask = rasterize(ellipseOutline({0, 0}, {16, 12}), pitch);
    const MaskFrame frame = frameFacing({24, 24, 24}, {0, 0, 1});
    double last = 0;
    for (const int radius : {2, 3, 4}) {
        Radiator radiator;
        radiateRaw(radiator, mask, std::span(&frame, 1), dims, fitFootprint(radius));
        const auto values = radiator.download({glm::ivec3(0), dims});
        const double sigma = radius / 3.0;
        const double peak = 0.1 / (pitch * pitch) / (sigma * std::sqrt(2 * 3.14159265358979));
        for (int z = 0; z <= radius; ++z) {
            EXPECT_NEAR(at(values, dims, {24, 24, 24 + z}), peak * std::exp(-0.5 * z * z / (sigma * sigma)),
                        0.05 * peak)
                << radius << " " << z;
        }
        const double half = test::crossingOf(values, dims, {24, 24, 24}, {0, 0, 1}, 8);
        EXPECT_GT(half, last + 0.2) << radius;
        last = half;
    }
}

TEST_F(SweepMethods, RawEnergyAlongAPathComesOnceAStep) {
    const auto frames = framesEachStep(
        std::vector<PathPiece>{line({0, 0, 0}, {0, 0, 2.5})[0], line({0, 0, 2.5}, {0, 0, 5})[0]});
    ASSERT_EQ(frames.size(), 6U); // at 0, 1 ... 5
    for (std::size_t n = 0; n < frames.size(); ++n) {
        EXPECT_NEAR(frames[n].origin.z, double(n), 1e-9);
    }
    // Far inside, every voxel has pitch^-2 elements of 0.1 a step, one step a voxel.
    const glm::ivec3 dims(40);
    const MaskRaster mask = rasterize(circleOutline({0, 0}, 12), 0.5);
    Radiator radiator;
    const auto path = framesEachStep(line({20, 20, 8}, {20, 20, 32}));
    radiateRaw(radiator, mask, path, dims, fitFootprint(3));
    EXPECT_NEAR(at(radiator.download({glm::ivec3(0), dims}), dims, {20, 20, 20}), 0.4, 0.01);
    // On wide slices the mask stays a circle in millimetres.
    radiateRaw(radiator, mask, std::span(path).subspan(12, 1), dims, fitFootprint(3, {1, 2, 1}), {1, 0.5, 1});
    const auto wide = radiator.download({glm::ivec3(0), dims});
    EXPECT_GT(at(wide, dims, {10, 10, 20}), 0.1F);
    EXPECT_GT(at(wide, dims, {20, 10 + 5, 20}), 0.1F);
    EXPECT_LT(at(wide, dims, {20, 10 + 8, 20}), 0.01F);
}

TEST_F(SweepMethods, OnlyWhatReachesTheGridIsSampled) {
    const glm::ivec3 dims(32);
    const MaskRaster mask = rasterize(circleOutline({0, 0}, 9), kSweepPitch);
    SweepGrid grid;
    grid.lo = glm::vec3(-4);
    grid.hi = glm::vec3(36);
    EXPECT_LT(sweepPiece(mask, line({16, 16, -50000}, {16, 16, 50000})[0], grid).pointCount(),
              2 * sweepPiece(mask, line({16, 16, -4}, {16, 16, 36})[0]).pointCount());
    EXPECT_EQ(sweepPiece(mask, line({16, 16, 50}, {16, 16, 90})[0], grid).pointCount(), 0U);
    Radiator radiator;
    PointGenerator generator;
    const auto sweep = [&](double reach) {
        sweepMask(radiator, generator, mask, line({16, 16, -reach}, {16, 16, reach}), dims, fitFootprint(3));
        return radiator.download({glm::ivec3(0), dims});
    };
    EXPECT_LT(largestDifference(sweep(50000), sweep(60)), 0.02F);
    // A mask as wide as a street: what lies in the grid is that of a small one, and made as quickly.
    const auto along = line({16, 16, 4}, {16, 16, 28});
    const auto ofWidth = [&](double width) {
        const Outline outline = rectangleOutline({-6, -5}, {width, 5});
        const SweepGrid whole = sweepGrid(dims, fitFootprint(3));
        sweepMask(radiator, generator,
                  rasterize(outlineInto(whole, outline, along, kSweepPitch, {}), kSweepPitch), along, dims,
                  fitFootprint(3));
        return radiator.download({glm::ivec3(0), dims});
    };
    EXPECT_LT(largestDifference(ofWidth(1e6), ofWidth(40)), 0.02F);
}

TEST_F(SweepMethods, ProjectionKeepsTheMaskAlongAnObliqueLine) {
    const glm::ivec3 dims(48);
    const glm::dvec3 from(14, 15, 10);
    const glm::dvec3 to(32, 30, 36);
    const MaskRaster mask = rasterize(ellipseOutline({0, 0}, {10, 7}), 1);
    const auto path = line(from, to);
    const auto values = projectSweep(mask, path, dims);
    const glm::dvec3 way = glm::normalize(to - from);
    const auto outline = reference::ellipse({10, 7});
    int inside = 0;
    int beyond = 0;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; x += 2) {
                const glm::dvec3 d = glm::dvec3(x, y, z) - from;
                const double along = glm::dot(d, way);
                const auto off = reference::distanceTo(
                    outline, {glm::dot(d, path[0].from.x), glm::dot(d, path[0].from.y)});
                const float value = at(values, dims, {x, y, z});
                if (along < -1e-6 || along > glm::length(to - from) + 1e-6) {
                    ASSERT_EQ(value, 0); // ends are cut off hard
                    ++beyond;
                } else if (off.distance < -2) {
                    ASSERT_GT(value, 0.99F);
                    ++inside;
                } else if (off.distance > 2) {
                    ASSERT_LT(value, 0.01F);
                } else if (std::abs(off.distance) > 0.3) {
                    ASSERT_EQ(value<0.5F, off.distance> 0) << off.distance;
                }
            }
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(beyond, 2000);
}

TEST_F(SweepMethods, ProjectionFollowsCurvesAndCorners) {
    const glm::ivec3 dims(80, 80, 64);
    const Helix helix{{40, 40, 20}, {40, 40, 44}, 22, 0.8};
    const reference::SweptCurve curve(
        [&](double t) {
            return reference::helixAt(helix.from, helix.to, {1, 0, 0}, helix.radius, helix.turns, t);
        },
        reference::SweptCurve::Turning::Least);
    const auto values = projectSweep(rasterize(ellipseOutline({0, 0}, {9, 6}), 1), helixPath(helix), dims);
    const auto outline = reference::ellipse({9, 6});
    int checked = 0;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; x += 5) {
                const auto place = curve.locate({x, y, z});
                const auto off = reference::distanceTo(outline, place.element);
                if (place.fromStart > 0.1 && place.toEnd > 0.1 && std::abs(off.distance) > 0.4) {
                    ASSERT_EQ(at(values, dims, {x, y, z}) < 0.5F, off.distance > 0)
                        << x << " " << y << " " << z << " " << off.distance;
                    ++checked;
                }
            }
        }
    }
    EXPECT_GT(checked, 10000);
    // The outer side of a bend is filled round.
    const std::vector<glm::dvec3> corner{{12, 32, 20}, {34, 32, 20}, {34, 54, 20}};
    const auto bend = projectSweep(rasterize(circleOutline({0, 0}, 8), 1), polylinePath(corner), dims);
    EXPECT_GT(at(bend, dims, {34 + 4, 32 - 4, 20}), 0.9F);
    EXPECT_EQ(at(bend, dims, {34 + 8, 32 - 8, 20}), 0);
}

TEST(Precision, ValuesAreWhatTheTextureHolds) {
    std::vector<float> values;
    for (int n = 0; n <= 10000; ++n) {
        values.push_back(float(n) / 10000);
    }
    auto bits8 = values;
    auto bits16 = values;
    auto bits32 = values;
    roundTo(Precision::Bits8, bits8);
    roundTo(Precision::Bits16, bits16);
    roundTo(Precision::Bits32, bits32);
    EXPECT_EQ(bits32, values);
    EXPECT_EQ(std::set<float>(bits8.begin(), bits8.end()).size(), 256U);
    for (std::size_t n = 0; n < values.size(); ++n) {
        EXPECT_NEAR(bits8[n], values[n], 0.5F / 255 + 1e-6F);
        EXPECT_NEAR(bits16[n], values[n], 2.5e-4F);
    }
    EXPECT_NE(bits16, values);
    std::vector<float> beyond{1.5F};
    roundTo(Precision::Bits8, beyond);
    EXPECT_EQ(beyond[0], 1);
}

} // namespace
} // namespace vs::sculpt

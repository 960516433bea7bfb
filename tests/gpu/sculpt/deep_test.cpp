// SPDX-License-Identifier: Apache-2.0
#include "tool_fixture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::sculpt {
namespace {

using test::drill;
using test::peel;
using test::Workpiece;

// Sweeps that go far beyond the grid.
class DeepTest : public test::GlTest {
protected:
    static std::size_t pointCount(const Workpiece& piece, const std::vector<field::SurfacePoint>& surface,
                                  const MaskRaster& mask, const ToolCut& how) {
        return sweepSurface(surface, mask, piece.geometry, how.sweep).pointCount();
    }

    // A ball of `radius` steps in the middle of the grid, met by rays along +z; bumps of up to `bump` of the
    // radius.
    static std::vector<field::SurfacePoint>
    ballUnder(const MaskRaster& mask, const volume::GridGeometry& geometry, double radius, double bump = 0) {
        const glm::dvec3 centre = 0.5 * glm::dvec3(geometry.dims - 1);
        const glm::dvec3 spacing = geometry.spacing();
        const auto inside = [&](glm::dvec3 mm) {
            const double wave = std::sin(9 * mm.x / radius) * std::sin(8 * mm.y / radius + 1);
            return radius * (1 + bump * wave) - glm::length(mm);
        };
        return test::surfaceUnder(mask, [&](glm::dvec2 e) -> std::optional<test::SurfaceHit> {
            glm::dvec3 mm((e - glm::dvec2(centre)) * glm::dvec2(spacing), -1.5 * radius);
            while (inside(mm) < 0 && mm.z < 0) {
                mm.z += 0.01 * radius;
            }
            if (mm.z >= 0) {
                return std::nullopt;
            }
            for (double step = 0.01 * radius; step > 1e-6 * radius; step /= 2) {
                mm.z += inside(mm) > 0 ? -step : step;
            }
            glm::dvec3 normal;
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 off(0);
                off[axis] = 1e-3;
                normal[axis] = inside(mm - off) - inside(mm + off);
            }
            return test::SurfaceHit{centre + mm / spacing, glm::normalize(normal)};
        });
    }
};

// The smallest value where `holds(voxel)`.
template <typename Holds>
float lowestWhere(const std::vector<float>& values, glm::ivec3 dims, const Holds& holds) {
    float lowest = 1e30F;
    std::size_t n = 0;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x, ++n) {
                lowest = holds(glm::ivec3(x, y, z)) ? std::min(lowest, values[n]) : lowest;
            }
        }
    }
    return lowest;
}

const glm::ivec3 kIsotropic(48);
const glm::ivec3 kCoarse(48, 48, 16); // of spacing 1 x 1 x 3

TEST_F(DeepTest, DrillingThroughTakesTheWholeColumn) {
    const auto mask = rasterize(circleOutline({23.5, 23.5}, 12), 0.5);
    for (const auto& [dims, spacing] : {std::pair(kIsotropic, glm::dvec3(1)), {kCoarse, {1, 1, 3}}}) {
        for (const glm::dvec3 way : {glm::dvec3(0, 0, 1), glm::dvec3(0.3, -0.2, 1)}) {
            const auto column = [&, s = spacing](glm::ivec3 v) {
                const glm::dvec2 axis = 23.5 + (v.z - 4) * s.z * glm::dvec2(way);
                return v.z >= 4 && glm::length(glm::dvec2(v) - axis) < 12 - 4;
            };
            const auto surface = test::slabUnder(mask, 4);
            std::vector<float> last;
            for (const double depth : {100.0, 4000.0, 1e7}) {
                Workpiece piece(dims, spacing);
                piece.cut(surface, mask, drill(depth, way));
                EXPECT_LT(pointCount(piece, surface, mask, drill(depth, way)), 100000U);
                const auto values = piece.values();
                EXPECT_GE(lowestWhere(values, dims, column), 0.99F)
                    << depth << " " << spacing.z << " " << way.x;
                EXPECT_LE(last.empty() ? 0 : test::largestDifference(values, last), 0.001F) << depth;
                last = values;
            }
        }
    }
}

TEST_F(DeepTest, DrillingThroughABall) {
    const auto mask = rasterize(circleOutline({23.5, 23.5}, 12), 0.5);
    Workpiece piece(kIsotropic);
    piece.cut(ballUnder(mask, piece.geometry, 20), mask, drill(4000));
    const auto column = [](glm::ivec3 v) {
        const glm::dvec3 off = glm::dvec3(v) - 23.5;
        return std::hypot(off.x, off.y) < 12 - 3 && (off.z > 0 || glm::length(off) < 20);
    };
    // The first layer is cut to its full extent too.
    EXPECT_GE(lowestWhere(piece.values(), kIsotropic, column), 0.99F);
}

TEST_F(DeepTest, PeelingDeeperNeverTakesLess) {
    for (const auto& [dims, spacing] : {std::pair(kIsotropic, glm::dvec3(1)), {kCoarse, {1, 1, 3}}}) {
        for (const double bump : {0.0, 0.08}) {
            for (const double wide : {8.0, 14.0, 23.0}) { // the last is wider than the ball
                const auto mask = rasterize(circleOutline({23.5, 23.5}, wide), 0.5);
                std::vector<float> last;
                std::size_t changedAt30 = 0;
                for (const double layers : {5.0, 12.0, 18.0, 22.0, 30.0, 31.0, 60.0, 400.0, 4000.0}) {
                    SCOPED_TRACE(testing::Message() << layers << " layers of " << wide << ", bumps " << bump
                                                    << ", slices " << spacing.z);
                    Workpiece piece(dims, spacing);
                    const auto surface = ballUnder(mask, piece.geometry, 20, bump);
                    piece.cut(surface, mask, peel(layers));
                    const auto changed = piece.sculpture.changedVoxels();
                    changedAt30 = layers == 30 ? changed : changedAt30;
                    EXPECT_GE(changed, changedAt30);
                    EXPECT_LT(pointCount(piece, surface, mask, peel(layers)), 600000U);
                    const auto values = piece.values();
                    float shortfall = 0;
                    for (std::size_t n = 0; n < last.size(); ++n) {
                        shortfall = std::max(shortfall, last[n] - values[n]);
                    }
                    EXPECT_LE(shortfall, bump > 0 ? 0.03F : 0.02F);
                    last = values;
                }
            }
        }
    }
}

TEST_F(DeepTest, PathsThatDivergeFillTheGrid) {
    // From inside a hollow sphere of radius 6 outwards, 4000 layers: all that lies beyond it in a cone.
    const glm::dvec3 centre(24, 24, 8);
    const auto mask = rasterize(circleOutline({0, 0}, 0.7), 0.06);
    Workpiece piece(kIsotropic);
    const auto surface = test::hollowSphereUnder(mask, centre, 6);
    piece.cut(surface, mask, peel(4000));
    const auto cone = [&](glm::ivec3 v) {
        const glm::dvec3 off = glm::dvec3(v) - centre;
        return glm::length(off) > 8 && std::hypot(off.x, off.y) < 0.28 * off.z; // well inside the mask's rim
    };
    EXPECT_GE(lowestWhere(piece.values(), kIsotropic, cone), 0.97F);
    EXPECT_LT(pointCount(piece, surface, mask, peel(4000)), 600000U);
}

// One patch far larger than the grid: split across and along depth until it has density 1.
TEST_F(DeepTest, AHugePatchHasDensityOne) {
    SweptPatches patches(-300, 700, 0);
    patches.clipTo(glm::vec3(-6), glm::vec3(53));
    const glm::vec3 way = glm::normalize(glm::vec3(0.2F, 0.1F, 1));
    for (const glm::vec2 at : {glm::vec2(-400, -300), {500, -200}, {-300, 500}, {600, 400}}) {
        patches.addCorner(glm::vec3(at, 0), way + glm::vec3(at * 5e-4F, 0), 1);
    }
    patches.addCell({0, 1, 2, 3});
    EXPECT_LT(patches.pointCount(), 1000000U);
    Radiator radiator;
    PointGenerator generator;
    radiator.begin(patches.pointBox(), kIsotropic, fitFootprint(3));
    generator.generate(patches,
                       [&](const gl::Buffer& points, std::size_t count) { radiator.deposit(points, count); });
    radiator.finish();
    const auto e = radiator.download({glm::ivec3(0), kIsotropic});
    EXPECT_GE(*std::min_element(e.begin(), e.end()), 0.98F);
    EXPECT_LE(*std::max_element(e.begin(), e.end()), 1.02F);
}

TEST_F(DeepTest, NothingIsSweptWhereTheGridIsNot) {
    Workpiece piece(kIsotropic);
    const auto mask = rasterize(circleOutline({23.5, 23.5}, 12), 0.5);
    EXPECT_EQ(pointCount(piece, test::slabUnder(mask, 60), mask, drill(4000)), 0U);
    EXPECT_TRUE(piece.cut(test::slabUnder(mask, 60), mask, drill(4000)).isEmpty());
    EXPECT_GT(pointCount(piece, test::slabUnder(mask, 60), mask, drill(4000, {0, 0, -1})), 0U);
}

} // namespace
} // namespace vs::sculpt

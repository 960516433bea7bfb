// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/sketch.h"

#include "property.h"
#include "studio/operations/trail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace vs::studio {
namespace {

TEST(Sketch, ClosedShapesMarkThePixelsInside) {
    const std::vector<Sketch> circle{{Shape::Circle, {{50, 50}, {70, 50}}}};
    const auto pixels = pixelsUnder(circle, 5, {100, 100});
    EXPECT_NEAR(double(pixels.size()), std::numbers::pi * 400, 30);
    for (const auto& p : pixels) {
        EXPECT_LT(glm::length(glm::dvec2(p) - glm::dvec2(50)), 20.01);
    }
}

TEST(Sketch, ARingIsHollowByTheEvenOddRule) {
    const std::vector<Sketch> one{{Shape::Rectangle, {{10, 10}, {30, 30}}}};
    EXPECT_EQ(pixelsUnder(one, 1, {64, 64}).size(), 400U);
}

TEST(Sketch, OpenLinesAreAsWideAsAsked) {
    const std::vector<Sketch> line{{Shape::FreeForm, {{10, 50}, {90, 50}}}};
    const auto pixels = pixelsUnder(line, 6, {100, 100});
    EXPECT_NEAR(double(pixels.size()), 80 * 6 + std::numbers::pi * 9, 20);
    for (const auto& p : pixels) {
        EXPECT_LE(std::abs(p.y - 50), 3.0F);
    }
}

TEST(Sketch, APolylineOfTwoPointsIsALineAndAStencilAnArea) {
    const std::vector<glm::dvec2> ends{{10, 50}, {90, 50}};
    EXPECT_EQ(pixelsUnder({{Shape::Polyline, ends}}, 6, {100, 100}),
              pixelsUnder({{Shape::FreeForm, ends}}, 6, {100, 100}));
    const std::vector<glm::dvec2> square{{10, 10}, {30, 10}, {30, 30}, {10, 30}};
    EXPECT_EQ(pixelsUnder({{Shape::Stencil, square}}, 6, {64, 64}).size(), 400U);
    EXPECT_EQ(outlineOf({Shape::Stencil, square}), outlineOf({Shape::Polyline, square}));
    EXPECT_TRUE(pixelsUnder({{Shape::Stencil, ends}}, 6, {100, 100}).empty());
}

TEST(Sketch, WhatLiesOutsideTheViewportIsLeftOut) {
    const std::vector<Sketch> line{{Shape::FreeForm, {{-50, 5}, {500, 5}}}};
    for (const auto& p : pixelsUnder(line, 3, {20, 10})) {
        EXPECT_TRUE(p.x > 0 && p.x < 20 && p.y > 0 && p.y < 10);
    }
    EXPECT_TRUE(pixelsUnder({{Shape::FreeForm, {}}}, 3, {20, 10}).empty());
}

// Pixel by pixel, by the definition; pixels on the very rim may fall on either side.
TEST(Sketch, LinesCoverThePixelsWhoseCentresAreNear) {
    test::checkProperty(200, [] {
        const auto place = [] { return glm::dvec2(*test::between(-40, 80), *test::between(-40, 80)); };
        const std::vector<glm::dvec2> points{place(), place(), place(), place()};
        const double width = *test::between(2, 30);
        const glm::ivec2 size(40, 30);
        const auto found = pixelsUnder({{Shape::FreeForm, points}}, width, size);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                double distance = glm::length(p - points[0]);
                for (std::size_t n = 1; n < points.size(); ++n) {
                    const glm::dvec2 way = points[n] - points[n - 1];
                    const double s =
                        glm::dot(way, way) > 0 ? glm::dot(p - points[n - 1], way) / glm::dot(way, way) : 0;
                    distance =
                        std::min(distance, glm::length(p - points[n - 1] - std::clamp(s, 0.0, 1.0) * way));
                }
                if (std::abs(distance - width / 2) > 1e-9) {
                    RC_ASSERT((std::find(found.begin(), found.end(), glm::vec2(p)) != found.end()) ==
                              (distance < width / 2));
                }
            }
        }
    });
}

TEST(Sketch, AreasCoverThePixelsInsideByTheEvenOddRule) {
    test::checkProperty(200, [] {
        std::vector<glm::dvec2> outline;
        for (int n = 0; n < 6; ++n) {
            outline.emplace_back(*test::between(-20, 60), *test::between(-20, 60) + 1e-3);
        }
        const glm::ivec2 size(40, 30);
        const auto found = pixelsUnder({{Shape::Stencil, outline}}, 1, size);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                bool isInside = false;
                bool isOnRim = false;
                for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
                    const glm::dvec2 a = outline[i];
                    const glm::dvec2 b = outline[j];
                    if ((a.y > p.y) != (b.y > p.y)) {
                        const double crossing = (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x;
                        isInside = isInside != (p.x < crossing);
                        isOnRim = isOnRim || std::abs(p.x - crossing) < 1e-9;
                    }
                }
                if (!isOnRim) {
                    RC_ASSERT((std::find(found.begin(), found.end(), glm::vec2(p)) != found.end()) ==
                              isInside);
                }
            }
        }
    });
}

TEST(Trail, OnAFinerLevelIsThatLevelsOwn) {
    test::checkProperty(30, [] {
        // Voxels are half and a quarter as large, and a third as large in the middle: of the coarser grid's
        // voxels all of theirs lie within.
        const field::BrickGrid grid{{150, 60, 40}, 32, {2, 3, 4}, {0.5, 1, 1.5}, 0.25, {0.5, 1.0 / 3, 0.25}};
        const volume::GridGeometry scene = volume::makeGeometry({75, 20, 10}, {1, 1.5, 4});
        const volume::GridGeometry finer = field::finerGeometry(scene, grid);
        const auto place = [] {
            return glm::dvec3(*test::between(-5, 80), *test::between(-5, 25), *test::between(-2, 12));
        };
        Trail trail{{place(), place(), place()}, *test::between(1, 9)};
        const auto told = [&](const glm::dvec3& p) { return p * grid.perSceneVoxel + grid.origin; };
        const auto onFiner = [&](std::optional<double> layer) {
            Trail finest = trail;
            std::transform(trail.points.begin(), trail.points.end(), finest.points.begin(), told);
            if (layer) {
                finest.points.front()[*trail.axis] = *layer;
            }
            return voxelsAlong(finest, finer).within(finer.box());
        };
        RC_ASSERT(finestAlong(trail, grid, finer).within(finer.box()) == onFiner({}).inside);
        // A disc is as thick as its slice, and nothing beside it.
        trail.axis = *test::below(3);
        const segment::FineSet disc = finestAlong(trail, grid, finer);
        const auto slice = std::floor(trail.points.front()[*trail.axis] + 0.5);
        for (int layer = 0; layer < grid.dims[*trail.axis]; ++layer) {
            const double inScene = (layer - grid.origin[*trail.axis]) / grid.perSceneVoxel[*trail.axis];
            const bool isInSlice = std::floor(inScene + 0.5) == slice;
            Box3 box = finer.box();
            box.lo[*trail.axis] = layer;
            box.hi[*trail.axis] = layer + 1;
            const auto expected =
                isInSlice ? onFiner(layer).within(box).inside : std::vector<std::uint8_t>(box.volume());
            RC_ASSERT(disc.within(box) == expected);
        }
    });
}

TEST(Trail, BallsCoverTheVoxelsWhoseCentresAreNear) {
    test::checkProperty(200, [] {
        auto geometry = volume::makeGeometry({14, 11, 9}, {1.0, 0.7, 2.5});
        geometry.worldFromVoxel[0] += 0.3 * geometry.worldFromVoxel[1]; // sheared
        const auto place = [] {
            return glm::dvec3(*test::between(-10, 25), *test::between(-10, 25), *test::between(-10, 25));
        };
        const Trail trail{{place(), place(), place()}, *test::between(1, 9)};
        const auto found = voxelsAlong(trail, geometry);
        const glm::dmat3 mm(geometry.worldFromVoxel);
        forEachVoxel(geometry.box(), [&](glm::ivec3 voxel, std::size_t) {
            double distance = 1e9;
            double through = 1e9; // voxels that the way itself may run through are in it anyway
            for (std::size_t n = 1; n < trail.points.size(); ++n) {
                const auto nearest = [&](const glm::dmat3& scale) {
                    const glm::dvec3 way = scale * (trail.points[n] - trail.points[n - 1]);
                    const glm::dvec3 offset = scale * (glm::dvec3(voxel) - trail.points[n - 1]);
                    const double s = glm::dot(way, way) > 0 ? glm::dot(offset, way) / glm::dot(way, way) : 0;
                    return glm::length(offset - std::clamp(s, 0.0, 1.0) * way);
                };
                distance = std::min(distance, nearest(mm));
                through = std::min(through, nearest(glm::dmat3(1)));
            }
            if (std::abs(distance - trail.radiusMm) > 1e-9 && (distance < trail.radiusMm || through > 0.87)) {
                RC_ASSERT(found.contains(voxel) == (distance < trail.radiusMm));
            }
        });
    });
}

TEST(Sketch, TooFewPointsEncloseNothing) {
    EXPECT_TRUE(outlineOf({Shape::FreeForm, {{1, 1}, {2, 2}}}).empty());
}

} // namespace
} // namespace vs::studio

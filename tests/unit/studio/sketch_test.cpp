// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/sketch.h"

#include <gtest/gtest.h>

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

TEST(Sketch, TooFewPointsEncloseNothing) {
    EXPECT_TRUE(outlineOf({Shape::FreeForm, {{1, 1}, {2, 2}}}).empty());
}

} // namespace
} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "render/colours/function_edits.h"

#include "render/colours/colour_map.h"
#include "render/colours/transfer_function_json.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace vs::render {
namespace {

TransferFunction twoHills() {
    TransferFunction f;
    f.points = {{0, 0, {10, 10, 10}}, {10, 0.5, {20, 0, 0}}, {20, 0, {30, 0, 0}},
                {40, 0, {0, 40, 0}},  {50, 0.8, {0, 50, 0}}, {60, 0, {0, 60, 0}}};
    return f;
}

bool isAscending(const TransferFunction& f) {
    return std::is_sorted(f.points.begin(), f.points.end(),
                          [](const auto& a, const auto& b) { return a.position < b.position; });
}

double opacity(const TransferFunction& f, double at) { return FunctionSampler(f).at(at, 0).w; }

TEST(FunctionEdits, APointAddedOnTheCurveChangesNothing) {
    TransferFunction f = twoHills();
    const TransferFunction before = f;
    const std::size_t point = addPoint(f, 45, opacity(f, 45));
    EXPECT_EQ(point, 4U);
    ASSERT_EQ(f.points.size(), 7U);
    for (double at = -5; at < 65; at += 0.7) {
        const auto a = FunctionSampler(before).at(at, 0);
        const auto b = FunctionSampler(f).at(at, 0);
        EXPECT_NEAR(a.w, b.w, 1e-9) << at;
        EXPECT_LT(glm::distance(glm::dvec3(a), glm::dvec3(b)), 0.004) << "within a display's steps at " << at;
    }
}

TEST(FunctionEdits, PointsStayBetweenTheirNeighbours) {
    TransferFunction f = twoHills();
    movePoint(f, 1, 1000, 7);
    EXPECT_EQ(f.points[1].position, 20);
    EXPECT_EQ(f.points[1].opacity, 1);
    movePoint(f, 1, -1000, -7);
    EXPECT_EQ(f.points[1].position, 0);
    EXPECT_EQ(f.points[1].opacity, 0);
    movePoint(f, 5, 1000, 0.5); // the last one has room
    EXPECT_EQ(f.points[5].position, 1000);
    EXPECT_TRUE(isAscending(f));
}

TEST(FunctionEdits, TheLastPointStays) {
    TransferFunction f = twoHills();
    while (f.points.size() > 1) {
        EXPECT_TRUE(removePoint(f, 0));
    }
    EXPECT_FALSE(removePoint(f, 0));
    EXPECT_EQ(f.points.size(), 1U);
}

TEST(FunctionEdits, HillsAreFoundUnderTheirCurve) {
    const TransferFunction f = twoHills();
    EXPECT_EQ(hillAt(f, 12, 0.1), (Hill{0, 2}));
    EXPECT_EQ(hillAt(f, 52, 0.3), (Hill{3, 5}));
    EXPECT_FALSE(hillAt(f, 12, 0.9)) << "above the curve";
    EXPECT_FALSE(hillAt(f, 30, 0.0)) << "between them";
    EXPECT_FALSE(hillAt(f, 100, 0.0)) << "beyond all";
}

TEST(FunctionEdits, AMovedHillKeepsItsFormAndStopsAtItsNeighbour) {
    TransferFunction f = twoHills();
    moveHill(f, {0, 2}, 5, 0.5);
    EXPECT_EQ(f.points[0].position, 5);
    EXPECT_EQ(f.points[1].position, 15);
    EXPECT_EQ(f.points[2].position, 25);
    EXPECT_EQ(f.points[1].opacity, 0.25);
    EXPECT_EQ(f.points[4], twoHills().points[4]);
    moveHill(f, {0, 2}, 500, 100);
    EXPECT_EQ(f.points[2].position, 40);
    EXPECT_EQ(f.points[0].position, 20);
    EXPECT_EQ(f.points[1].opacity, 1);
}

TEST(FunctionEdits, ABoxStandsInsteadOfWhatWasThereAndLeavesTheRest) {
    TransferFunction f = twoHills();
    const TransferFunction before = f;
    const Colour colour = kSafeColours[1];
    const Hill box = addBox(f, {45, 55}, 0.3, colour);
    EXPECT_TRUE(isAscending(f));
    EXPECT_NEAR(opacity(f, 50), 0.3, 1e-9);
    EXPECT_EQ(f.points[box.first].position, 45);
    EXPECT_EQ(f.points[box.last].position, 55);
    for (std::size_t i = box.first; i <= box.last; ++i) {
        EXPECT_EQ(f.points[i].colour, colour);
    }
    for (const double at : {0.0, 7.0, 15.0, 30.0, 42.0, 44.9, 55.1, 58.0, 70.0}) {
        EXPECT_NEAR(opacity(f, at), opacity(before, at), 1e-9) << at;
    }
}

TEST(FunctionEdits, ColoursOfAMapBecomeThePointsOwnAndBack) {
    TransferFunction f = twoHills();
    useColourMap(f, "ember");
    ASSERT_TRUE(f.colours);
    EXPECT_EQ(f.colours->range, (Range{0, 60}));
    const auto mapped = FunctionSampler(f).at(50, 0);
    useColourMap(f, "marine");
    EXPECT_EQ(f.colours->map, "marine");
    useColourMap(f, "ember");
    paintPoint(f, 0, {1, 2, 3});
    EXPECT_FALSE(f.colours);
    EXPECT_EQ(f.points[0].colour, Colour(1, 2, 3));
    EXPECT_LT(glm::distance(FunctionSampler(f).at(50, 0), mapped), 0.004);
}

TEST(FunctionEdits, SafeColoursAreTakenInTurn) {
    TransferFunction f = functionOfBoth({10, 20}, 5);
    std::set<std::uint32_t> seen;
    for (std::size_t i = 1; i < kSafeColours.size(); ++i) {
        const Colour colour = nextSafeColour(f);
        seen.insert(std::uint32_t(colour.x) << 16 | std::uint32_t(colour.y) << 8 | colour.z);
        addShape(f, {Trapezoid{}, colour, 0.5});
    }
    EXPECT_EQ(seen.size(), kSafeColours.size() - 1);
    (void)nextSafeColour(f); // all are used: one of them again
}

TEST(FunctionEdits, ShapesAreFoundMovedAndRemoved) {
    TransferFunction f = functionOfBoth({10, 20}, 10);
    addShape(f, {Trapezoid{{30, 30}, {25, 35}, {2, 8}, {}}, kSafeColours[2], 0.5});
    EXPECT_EQ(shapeAt(f, {30, 7}), 0U);
    EXPECT_FALSE(shapeAt(f, {26, 3})) << "beside the triangle's lower end";
    EXPECT_EQ(shapeAt(f, {15, 5}), 1U);
    moveShape(f.shapes[0], {-15, 0});
    EXPECT_EQ(shapeAt(f, {15, 7}), 0U) << "it lies in front";
    removeShape(f, 0);
    EXPECT_EQ(shapeAt(f, {15, 7}), 0U);
    EXPECT_EQ(f.shapes.size(), 1U);
}

TEST(FunctionEdits, CornersDoNotPassOneAnotherAndTrianglesStayTriangles) {
    Trapezoid triangle{{30, 30}, {25, 35}, {2, 8}, {}};
    moveCorner(triangle, 0, {28, 1});
    EXPECT_EQ(triangle.base, (Range{28, 28}));
    EXPECT_EQ(triangle.gradients, (Range{1, 8}));
    moveCorner(triangle, 2, {100, -50});
    EXPECT_EQ(triangle.top, (Range{35, 35}));
    EXPECT_EQ(triangle.gradients, (Range{1, 1}));
    const auto corners = cornersOf(triangle);
    EXPECT_EQ(corners[0], glm::dvec2(28, 1));
    EXPECT_EQ(corners[3], glm::dvec2(35, 1));
}

TEST(FunctionEdits, PaintIsFullUnderTheBrushAndGoneWhenErased) {
    TransferFunction f;
    f.kind = FunctionKind::TwoD;
    addShape(f, makePainting({0, 100}, {0, 10}, kSafeColours[0]));
    auto& painting = std::get<Painting>(f.shapes[0].form);
    EXPECT_FALSE(shapeAt(f, {50, 5})) << "nothing is painted yet";
    paintStroke(painting, {20, 5}, {80, 5}, {8, 1}, false);
    const FunctionSampler sampler(f);
    for (const double value : {20.0, 50.0, 80.0}) {
        EXPECT_NEAR(sampler.at(value, 5).w, f.shapes[0].opacity, 0.01) << value;
    }
    EXPECT_EQ(sampler.at(50, 7).w, 0);
    EXPECT_EQ(sampler.at(95, 5).w, 0);
    EXPECT_EQ(shapeAt(f, {50, 5}), 0U);
    const auto once = painting;
    paintStroke(painting, {20, 5}, {80, 5}, {8, 1}, false);
    EXPECT_EQ(painting, once) << "the same stroke again changes nothing";
    paintStroke(painting, {20, 5}, {80, 5}, {16, 2}, true);
    EXPECT_TRUE(
        std::all_of(painting.cells.begin(), painting.cells.end(), [](auto cell) { return cell == 0; }));
}

TEST(FunctionEdits, WhatIsEditedGoesThroughAFile) {
    TransferFunction f = functionOfBoth({10, 20}, 10);
    addShape(f, makePainting({0, 100}, {0, 10}, nextSafeColour(f)));
    paintStroke(std::get<Painting>(f.shapes[0].form), {20, 5}, {80, 5}, {8, 1}, false);
    EXPECT_EQ(transferFunctionFromJson(toJson(f), "test"), f);
    TransferFunction g = functionOfRange({100, 200});
    addBox(g, {120, 140}, 0.4, kSafeColours[0]);
    EXPECT_EQ(transferFunctionFromJson(toJson(g), "test"), g);
}

} // namespace
} // namespace vs::render

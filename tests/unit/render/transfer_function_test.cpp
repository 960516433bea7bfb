// SPDX-License-Identifier: Apache-2.0
#include "render/colours/transfer_function.h"

#include "render/colours/colour_map.h"

#include <gtest/gtest.h>

namespace vs::render {
namespace {

TEST(TransferFunction, OpacityIsLinearAndColourLinearInOklab) {
    TransferFunction f;
    f.points = {{100, 0.2, {255, 0, 0}}, {200, 0.6, {0, 0, 255}}};
    const FunctionSampler sampler(f);
    EXPECT_NEAR(sampler.at(150, 0).w, 0.4, 1e-12);
    const glm::dvec3 middle = glm::mix(oklabFromLinear({1, 0, 0}), oklabFromLinear({0, 0, 1}), 0.5);
    EXPECT_LT(glm::distance(oklabFromLinear(glm::dvec3(sampler.at(150, 0))), middle), 1e-6);
    EXPECT_NEAR(sampler.at(-1e9, 0).w, 0.2, 1e-12) << "beyond the ends it stays";
    EXPECT_NEAR(sampler.at(1e9, 0).w, 0.6, 1e-12);
    EXPECT_LT(glm::distance(glm::dvec3(sampler.at(1e9, 0)), glm::dvec3(0, 0, 1)), 1e-6);
}

TEST(TransferFunction, TwoPointsInOnePlaceMakeAStep) {
    TransferFunction f;
    f.points = {{0, 0}, {10, 0}, {10, 1}, {20, 1}};
    const FunctionSampler sampler(f);
    EXPECT_EQ(sampler.at(9.999, 0).w, 0);
    EXPECT_EQ(sampler.at(10, 0).w, 1);
}

TEST(TransferFunction, AColourMapIsSpreadOverItsRange) {
    TransferFunction f;
    f.points = {{0, 0.5}};
    f.colours = SpreadColours{"ember", {100, 300}};
    const FunctionSampler sampler(f);
    const auto map = findColourMap("ember");
    const auto expected = glm::clamp(linearFromOklab(map->at(0.25)), 0.0, 1.0);
    EXPECT_LT(glm::distance(glm::dvec3(sampler.at(150, 0)), expected), 1e-9);
}

TEST(TransferFunction, ShapesAreFullInTheMiddleAndClearOutside) {
    TransferFunction f;
    f.kind = FunctionKind::TwoD;
    f.shapes = {{Trapezoid{{100, 100}, {50, 150}, {0, 10}, {0.5, 0}}, {255, 0, 0}, 0.8}};
    const FunctionSampler sampler(f);
    EXPECT_NEAR(sampler.at(100, 5).w, 0.8, 1e-9);
    EXPECT_EQ(sampler.at(130, 5).w, 0) << "halfway up the triangle is from 75 to 125";
    EXPECT_GT(sampler.at(130, 8).w, 0);
    EXPECT_LT(sampler.at(130, 8).w, 0.8) << "near its edge";
    EXPECT_EQ(sampler.at(100, 10.1).w, 0);
    EXPECT_LT(glm::distance(glm::dvec3(sampler.at(200, 5)), glm::dvec3(1, 0, 0)), 1e-6)
        << "the colour goes on, or edges would darken";
}

TEST(TransferFunction, OverlapsCombineAsAsked) {
    TransferFunction f;
    f.kind = FunctionKind::TwoD;
    const Trapezoid box{{0, 10}, {0, 10}, {0, 10}, {0, 0}};
    f.shapes = {{box, {255, 0, 0}, 0.5}, {box, {0, 0, 255}, 0.6}};
    EXPECT_NEAR(FunctionSampler(f).at(5, 5).w, 0.8, 1e-9);
    EXPECT_NEAR(FunctionSampler(f).at(5, 5).x, 0.5 / 0.8, 1e-9) << "the first lies in front";
    f.combine = Combine::Max;
    EXPECT_NEAR(FunctionSampler(f).at(5, 5).w, 0.6, 1e-9);
    EXPECT_NEAR(FunctionSampler(f).at(5, 5).x, 0, 1e-9);
}

TEST(TransferFunction, PaintedCellsAreInterpolated) {
    TransferFunction f;
    f.kind = FunctionKind::TwoD;
    f.shapes = {{Painting{{0, 20}, {0, 10}, {2, 1}, {0, 255}}, {255, 255, 255}, 1}};
    const FunctionSampler sampler(f);
    EXPECT_NEAR(sampler.at(5, 5).w, 0, 1e-9);
    EXPECT_NEAR(sampler.at(10, 5).w, 0.5, 1e-9);
    EXPECT_NEAR(sampler.at(15, 5).w, 1, 1e-9);
    EXPECT_EQ(sampler.at(21, 5).w, 0);
}

TEST(TransferFunction, RelativePositionsAreMeasuredAgainstTheVolume) {
    Anchors anchors;
    anchors.values = {-100, 900};
    anchors.robustValues = {0, 500};
    anchors.gradientTop = 40;
    TransferFunction f;
    f.points = {{0.25, 0}, {1, 1}};
    f.colours = SpreadColours{"grey", {0, 0.5}};
    EXPECT_EQ(resolve(f, anchors), f) << "absolute positions stay";
    f.positions = Positions::Relative;
    EXPECT_EQ(resolve(f, anchors).points[0].position, 150);
    EXPECT_EQ(resolve(f, anchors).colours->range, (Range{-100, 400}));
    f.positions = Positions::Robust;
    EXPECT_EQ(resolve(f, anchors).points[0].position, 125);
    f.kind = FunctionKind::Gradient;
    EXPECT_EQ(resolve(f, anchors).points[0].position, 10);
    f.kind = FunctionKind::TwoD;
    f.shapes = {{Trapezoid{{0, 1}, {0.5, 1}, {0, 0.5}, {0, 0}}, {}, 1}};
    const TransferFunction resolved = resolve(f, anchors);
    const auto& shape = std::get<Trapezoid>(resolved.shapes[0].form);
    EXPECT_EQ(shape.top, (Range{250, 500}));
    EXPECT_EQ(shape.gradients, (Range{0, 20}));
}

TEST(TransferFunction, LandmarksAreMetAndWhatLiesBetweenThemIsEvenlySpread) {
    Anchors anchors;
    anchors.landmarks = {10, 20, 80, 110, 200};
    anchors.stepMm = 0.5;
    TransferFunction f;
    f.positions = Positions::Landmarks;
    for (const double at : {-1.0, 0.0, 0.5, 1.0, 2.0, 2.5, 3.0, 4.0, 5.0}) {
        f.points.push_back({at, 0});
    }
    const TransferFunction resolved = resolve(f, anchors);
    constexpr double expected[] = {0, 10, 15, 20, 80, 95, 110, 200, 290};
    for (std::size_t i = 0; i < f.points.size(); ++i) {
        EXPECT_NEAR(resolved.points[i].position, expected[i], 1e-9) << f.points[i].position;
    }
    f.kind = FunctionKind::TwoD;
    f.shapes = {{Trapezoid{{1, 2}, {2, 3}, {0, 0.5}, {0, 0}}, {}, 1}};
    const TransferFunction plane = resolve(f, anchors); // of its own: the shape lies in it
    const auto& shape = std::get<Trapezoid>(plane.shapes[0].form);
    EXPECT_EQ(shape.base, (Range{20, 80}));
    EXPECT_EQ(shape.gradients, (Range{0, 100}))
        << "half of a step from air to white within a voxel of 0.5 mm";
}

TEST(TransferFunction, HounsfieldUnitsAreMeasuredFromAirToWater) {
    Anchors anchors;
    anchors.airAndWater = {10, 70}; // eight bits
    TransferFunction f;
    f.positions = Positions::Hounsfield;
    f.points = {{-1000, 0}, {0, 0}, {500, 0}};
    EXPECT_NEAR(resolve(f, anchors).points[0].position, 10, 1e-9);
    EXPECT_NEAR(resolve(f, anchors).points[1].position, 70, 1e-9);
    EXPECT_NEAR(resolve(f, anchors).points[2].position, 100, 1e-9);
    f.kind = FunctionKind::Gradient;
    EXPECT_NEAR(resolve(f, anchors).points[2].position, 30, 1e-9);
    anchors.stepMm = 3;
    EXPECT_NEAR(resolve(f, anchors).points[2].position, 10, 1e-9) << "an edge is as wide as a voxel at least";
    anchors.stepMm = 0.3;
    EXPECT_NEAR(resolve(f, anchors).points[2].position, 30, 1e-9);
}

TEST(TransferFunction, OpacitiesAddUpAsTheirLengthsDo) {
    const double half = opacityOver(0.75, 0.5);
    EXPECT_NEAR(1 - (1 - half) * (1 - half), 0.75, 1e-12);
    EXPECT_EQ(opacityOver(1, 0.5), 1);
}

} // namespace
} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
// Distances from edges of marks, against what a person would work out.
#include "marking/mark_shape.h"
#include "property.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vs::marking {
namespace {

TEST(MarkShapeTest, ALineIsAsWideAsItsPointsSay) {
    const std::vector<PathPoint> path{{{0, 0, 0}, 2, 1}, {{10, 0, 0}, 4, 0.5}};
    EXPECT_DOUBLE_EQ(onLine(path, {0, 0, 0}).insideMm, 2);
    EXPECT_DOUBLE_EQ(onLine(path, {5, 3, 0}).insideMm, 0);
    EXPECT_DOUBLE_EQ(onLine(path, {5, 0, 0}).opacity, 0.75);
    EXPECT_DOUBLE_EQ(onLine(path, {14, 0, 0}).insideMm, 0) << "its end is round";
    EXPECT_DOUBLE_EQ(onLine(path, {-3, 0, 0}).insideMm, -1);
    EXPECT_DOUBLE_EQ(onLine(std::vector{path[0]}, {0, 1, 0}).insideMm, 1) << "a dot";
    EXPECT_LT(onLine({}, {0, 0, 0}).insideMm, -1e20);
}

TEST(MarkShapeTest, AnAreasDistancesAreThoseOfItsEdges) {
    test::checkProperty(20, [] {
        const double left = *test::below(100) * 0.37;
        const double top = *test::below(100) * 0.41;
        const double width = 12 + *test::below(100) * 0.3;
        const double height = 12 + *test::below(100) * 0.3;
        const std::array<AreaDistances::Outline, 1> box{AreaDistances::Outline{
            {left, top}, {left + width, top}, {left + width, top + height}, {left, top + height}}};
        const AreaDistances area(box, 6);
        const auto exactAt = [&](glm::dvec2 p) {
            const glm::dvec2 out = glm::abs(p - glm::dvec2(left + width / 2, top + height / 2)) -
                                   0.5 * glm::dvec2(width, height);
            const double distance = glm::length(glm::max(out, 0.0)) + std::min(std::max(out.x, out.y), 0.0);
            return std::clamp(-distance, -6.0, 6.0);
        };
        for (int i = 0; i < 200; ++i) {
            const glm::dvec2 p(left - 8 + *test::below(1000) * (width + 16) / 1000,
                               top - 8 + *test::below(1000) * (height + 16) / 1000);
            // Between pixels distances are interpolated, which cuts corners.
            RC_ASSERT(std::abs(area.insidePixels(p) - exactAt(p)) < 0.45);
            const glm::dvec2 centre = glm::floor(p) + 0.5;
            RC_ASSERT(std::abs(area.insidePixels(centre) - exactAt(centre)) < 1e-4);
        }
    });
}

// A ring, drawn as one outline: to the hole and back along one line, which is no edge.
TEST(MarkShapeTest, LinesToAndFroAreNoEdges) {
    const std::array<AreaDistances::Outline, 1> ring{AreaDistances::Outline{
        {0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}, {15, 15}, {15, 25}, {25, 25}, {25, 15}, {15, 15}}};
    const AreaDistances area(ring, 5);
    EXPECT_NEAR(area.insidePixels({7.5, 7.5}), 5, 1e-6) << "on the line that joins the two";
    EXPECT_LT(area.insidePixels({20, 20}), 0) << "in the hole";
    EXPECT_NEAR(area.insidePixels({37, 20.5}), 3, 1e-6);
    EXPECT_NEAR(area.insidePixels({-2, 20.5}), -2, 1e-6);
}

TEST(MarkShapeTest, NoOutlineHasNoInside) {
    const AreaDistances nothing({}, 5);
    EXPECT_LT(nothing.insidePixels({3, 3}), 0);
}

} // namespace
} // namespace vs::marking

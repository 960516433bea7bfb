// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/stroke.h"

#include "property.h"

#include <gtest/gtest.h>

namespace vs::sculpt {
namespace {

double distanceToWay(const PenPoint& point, const Stroke& stroke) {
    double nearest = glm::distance(point.pixel, stroke.front().pixel);
    for (std::size_t n = 1; n < stroke.size(); ++n) {
        const glm::dvec2 from = stroke[n - 1].pixel;
        const glm::dvec2 way = stroke[n].pixel - from;
        const double along =
            glm::clamp(glm::dot(point.pixel - from, way) / std::max(glm::dot(way, way), 1e-9), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(point.pixel, from + along * way));
    }
    return nearest;
}

// The pen has been everywhere that the stroke had it, to a pixel, and begins and ends where it did.
TEST(StrokeTest, AStraightenedStrokeGoesTheWayOfTheStroke) {
    test::checkProperty(200, [] {
        Stroke stroke;
        glm::dvec2 pixel(0);
        const int count = 1 + *test::below(60);
        for (int n = 0; n < count; ++n) {
            pixel += glm::dvec2(*test::below(16) - 4, *test::below(7) - 3);
            stroke.push_back({pixel, (1 + *test::below(10)) / 10.0});
        }
        const Stroke kept = straightened(stroke);
        RC_ASSERT(kept.size() <= stroke.size());
        RC_ASSERT(kept.front().pixel == stroke.front().pixel);
        RC_ASSERT(kept.back().pixel == stroke.back().pixel);
        RC_ASSERT(kept.back().pressure == stroke.back().pressure);
        for (const PenPoint& point : stroke) {
            RC_ASSERT(distanceToWay(point, kept) <= 1.0001);
        }
    });
}

TEST(StrokeTest, AStraightStrokeIsTwoPoints) {
    Stroke stroke;
    for (int n = 0; n <= 50; ++n) {
        stroke.push_back({{3.0 * n, 2.0 * n + 0.4 * (n % 2)}, 0.5 + 0.01 * n});
    }
    EXPECT_EQ(2U, straightened(stroke).size());
    stroke[25].pressure = 1; // a dot that is pressed harder stays
    EXPECT_EQ(5U, straightened(stroke).size());
    stroke[25] = {{75, 90}, 0.75};
    EXPECT_EQ(5U, straightened(stroke).size());
    EXPECT_TRUE(straightened({}).empty());
}

} // namespace
} // namespace vs::sculpt

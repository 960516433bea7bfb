// SPDX-License-Identifier: Apache-2.0
#include "sculpt/path.h"

#include <gtest/gtest.h>

namespace vs::sculpt {
namespace {

void expectNear(glm::dvec3 a, glm::dvec3 b) { EXPECT_LT(glm::length(a - b), 1e-9); }

TEST(Path, ALineAlongZHasTheMaskUpright) {
    const auto pieces = polylinePath(std::vector<glm::dvec3>{{1, 2, 3}, {1, 2, 3}, {1, 2, 10}});
    ASSERT_EQ(pieces.size(), 1U);
    expectNear(pieces[0].from.origin, {1, 2, 3});
    expectNear(pieces[0].to.origin, {1, 2, 10});
    expectNear(pieces[0].from.x, {1, 0, 0});
    expectNear(pieces[0].from.y, {0, 1, 0});
    expectNear(pieces[0].from.place({2, 5}), {3, 7, 3});
}

TEST(Path, FramesStayOrthonormalAndAcrossTheLine) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {10, 2, 1}, {12, 9, -4}, {3, 9, 8}};
    const auto pieces = polylinePath(points);
    for (const PathPiece& piece : pieces) {
        for (const MaskFrame& frame : {piece.from, piece.to}) {
            EXPECT_NEAR(glm::length(frame.x), 1, 1e-9);
            EXPECT_NEAR(glm::length(frame.y), 1, 1e-9);
            EXPECT_NEAR(glm::dot(frame.x, frame.y), 0, 1e-9);
        }
        const glm::dvec3 way = piece.to.origin - piece.from.origin;
        if (glm::length(way) > 0) {
            expectNear(glm::cross(piece.from.x, piece.from.y), glm::normalize(way));
        }
    }
    // Each piece begins where the one before ended.
    for (std::size_t n = 1; n < pieces.size(); ++n) {
        expectNear(pieces[n].from.origin, pieces[n - 1].to.origin);
        expectNear(pieces[n].from.x, pieces[n - 1].to.x);
    }
    expectNear(pieces.back().to.origin, points.back());
}

TEST(Path, TurningInAPlaneDoesNotTwist) {
    // Along a square in the xy plane, y of the mask (or x) keeps pointing along z.
    const auto pieces =
        polylinePath(std::vector<glm::dvec3>{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}});
    expectNear(pieces.back().to.y, pieces.front().from.y);
}

TEST(Path, TooFewPointsAreNoPath) {
    EXPECT_TRUE(polylinePath({}).empty());
    EXPECT_TRUE(polylinePath(std::vector<glm::dvec3>{{1, 1, 1}}).empty());
    EXPECT_TRUE(polylinePath(std::vector<glm::dvec3>{{1, 1, 1}, {1, 1, 1}}).empty());
}

} // namespace
} // namespace vs::sculpt

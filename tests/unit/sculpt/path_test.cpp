// SPDX-License-Identifier: Apache-2.0
#include "sculpt/path/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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

// Frames are orthonormal, x cross y is the tangent, and each piece begins as the one before ended.
void expectSound(const std::vector<PathPiece>& pieces) {
    ASSERT_FALSE(pieces.empty());
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        for (const MaskFrame& frame : {pieces[n].from, pieces[n].to}) {
            EXPECT_NEAR(glm::length(frame.x), 1, 1e-9);
            EXPECT_NEAR(glm::length(frame.y), 1, 1e-9);
            EXPECT_NEAR(glm::dot(frame.x, frame.y), 0, 1e-9);
        }
        EXPECT_GT(glm::dot(pieces[n].from.x, pieces[n].to.x), std::cos(0.11));
        if (n > 0) {
            expectNear(pieces[n].from.origin, pieces[n - 1].to.origin);
            expectNear(pieces[n].from.x, pieces[n - 1].to.x);
            expectNear(pieces[n].from.y, pieces[n - 1].to.y);
        }
    }
}

glm::dvec3 facing(const MaskFrame& frame) { return glm::cross(frame.x, frame.y); }

// The smallest distance from a point to the corners and the middles of a path's chords.
double distanceTo(const std::vector<PathPiece>& pieces, glm::dvec3 p) {
    double least = 1e30;
    for (const PathPiece& piece : pieces) {
        const glm::dvec3 way = piece.to.origin - piece.from.origin;
        const double square = std::max(glm::dot(way, way), 1e-30);
        const double t = std::clamp(glm::dot(p - piece.from.origin, way) / square, 0.0, 1.0);
        least = std::min(least, glm::length(p - piece.from.origin - t * way));
    }
    return least;
}

TEST(Path, HelixKeepsToItsCurveAndFrenetPointsAtTheAxis) {
    const Helix helix{{20, 20, 5}, {20, 20, 45}, 12, 1.5};
    for (const FrameKind kind : {FrameKind::ParallelTransport, FrameKind::Frenet}) {
        const auto pieces = helixPath(helix, kind);
        expectSound(pieces);
        expectNear(pieces.front().from.origin, {32, 20, 5});
        expectNear(pieces.back().to.origin, {8, 20, 45});
        for (double t = 0; t <= 1; t += 0.0037) {
            EXPECT_LT(distanceTo(pieces, helix.at(t)), 0.0101);
        }
        const double angle = 2 * std::numbers::pi * 1.5;
        for (const PathPiece& piece : pieces) {
            const glm::dvec3 p = piece.to.origin;
            const double turn = (p.z - 5) / 40 * angle; // right-handed: rises while it turns from x to y
            const glm::dvec3 outwards(std::cos(turn), std::sin(turn), 0);
            const glm::dvec3 tangent =
                glm::normalize(glm::dvec3(-12 * angle * outwards.y, 12 * angle * outwards.x, 40));
            EXPECT_LT(glm::length(facing(piece.to) - tangent), 1e-9);
            if (kind == FrameKind::Frenet) {
                EXPECT_LT(glm::length(piece.to.x + outwards), 1e-9);
            }
        }
    }
    EXPECT_LT(helixPath({{0, 0, 0}, {0, 0, 30}, 10, -0.25}).back().to.origin.y, -9.99);
}

TEST(Path, ParallelTransportTurnsAgainstFrenetByTheTorsion) {
    // Analytic: relative to the Frenet frame, a rotation minimising one turns by minus the torsion times the
    // length.
    const Helix helix{{0, 0, 0}, {0, 0, 60}, 10, 2};
    const double angle = 4 * std::numbers::pi;
    const double length = std::hypot(10 * angle, 60.0);
    const double torsion = 60 * angle / (length * length);
    const auto frenet = helixPath(helix, FrameKind::Frenet);
    const auto parallel = helixPath(helix);
    const auto angleFrom = [](const MaskFrame& a, const MaskFrame& b) {
        return std::atan2(glm::dot(b.x, a.y), glm::dot(b.x, a.x));
    };
    const double turned = angleFrom(frenet.back().to, parallel.back().to) -
                          angleFrom(frenet.front().from, parallel.front().from);
    EXPECT_NEAR(std::remainder(turned + torsion * length, 2 * std::numbers::pi), 0, 1e-4);
}

TEST(Path, SplineGoesThroughItsPointsSmoothly) {
    const std::vector<glm::dvec3> points{{5, 5, 5}, {20, 8, 12}, {20, 8, 12}, {30, 25, 10}, {12, 33, 30}};
    for (const FrameKind kind : {FrameKind::ParallelTransport, FrameKind::Frenet}) {
        const auto pieces = splinePath(points, kind);
        expectSound(pieces);
        for (const glm::dvec3& point : points) {
            EXPECT_LT(distanceTo(pieces, point), 1e-9);
        }
        for (const PathPiece& piece : pieces) { // no kinks
            EXPECT_GT(glm::dot(facing(piece.from), facing(piece.to)), std::cos(0.051));
        }
    }
    // Three points of a wide circle at equal distances: close to the circle between them as well.
    const auto onCircle = [](double a) { return glm::dvec3(50 * std::cos(a), 50 * std::sin(a), 0); };
    std::vector<glm::dvec3> circle;
    for (int n = 0; n < 7; ++n) {
        circle.push_back(onCircle(0.2 * n));
    }
    EXPECT_LT(distanceTo(splinePath(circle), onCircle(0.5)), 0.02);
}

TEST(Path, SplineOfTwoPointsIsALineAndOneStraightBackTurns) {
    const auto line = splinePath(std::vector<glm::dvec3>{{1, 2, 3}, {1, 2, 13}});
    ASSERT_EQ(line.size(), 1U);
    expectNear(line[0].to.x, {1, 0, 0});
    const auto back = splinePath(std::vector<glm::dvec3>{{0, 0, 0}, {10, 0, 0}, {0, 0, 0}});
    expectSound(back);
    EXPECT_LT(distanceTo(back, {10, 0, 0}), 1e-9);
    expectNear(facing(back.back().to), {-1, 0, 0});
}

TEST(Path, FrenetSurvivesStraightPartsAndInflections) {
    // An S in a plane with a straight middle: x stays in the plane, on one side all along.
    const std::vector<glm::dvec3> s{{0, 0, 7}, {10, 4, 7}, {20, 4, 7}, {30, 4, 7}, {40, 4, 7}, {50, 8, 7}};
    const auto pieces = splinePath(s, FrameKind::Frenet);
    expectSound(pieces);
    for (const PathPiece& piece : pieces) {
        EXPECT_NEAR(std::abs(piece.to.y.z), 1, 1e-6);
        EXPECT_NEAR(piece.to.y.z, pieces.front().from.y.z, 1e-6);
    }
    expectSound(splinePath(std::vector<glm::dvec3>{{0, 0, 0}, {0, 5, 0}, {0, 9, 0}}, FrameKind::Frenet));
    // A polyline's straight parts do not twist; the mask turns to the next bend at the corner itself.
    const auto poly = polylinePath(
        std::vector<glm::dvec3>{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 9, 9}, {0, 9, 9}}, FrameKind::Frenet);
    expectSound(poly);
    for (const PathPiece& piece : poly) {
        if (glm::length(piece.to.origin - piece.from.origin) > 1) {
            expectNear(piece.from.x, piece.to.x);
        }
    }
    expectNear(poly.front().from.x, {0, 1, 0});
}

TEST(Path, ARecordedWayLosesItsTremble) {
    std::mt19937 random(7);
    std::normal_distribution<double> tremble(0, 0.25);
    std::vector<glm::dvec3> pen;
    const auto truth = [](double t) { return glm::dvec3(60 * t, 20 * std::sin(3 * t), 10 + 5 * t); };
    for (int n = 0; n <= 400; ++n) {
        const double t = n / 400.0;
        const bool isEnd = n == 0 || n == 400;
        pen.push_back(truth(t) + (isEnd ? 0.0 : 1.0) * glm::dvec3(tremble(random), tremble(random), 0));
        pen.push_back(pen.back());
    }
    const auto pieces = recordedPath(pen);
    expectSound(pieces);
    expectNear(pieces.front().from.origin, truth(0));
    expectNear(pieces.back().to.origin, truth(1));
    double squared = 0;
    double turned = 0;
    for (const PathPiece& piece : pieces) {
        const double t = piece.to.origin.x / 60;
        squared += std::pow(glm::length(piece.to.origin - truth(t)), 2) / double(pieces.size());
        turned += std::acos(std::min(glm::dot(facing(piece.from), facing(piece.to)), 1.0));
    }
    EXPECT_LT(std::sqrt(squared), 0.25);
    EXPECT_LT(turned, 4); // the true curve turns by about 1.6 radians, the pen's by hundreds
    EXPECT_TRUE(recordedPath(std::vector<glm::dvec3>{{1, 1, 1}, {1, 1, 1}}).empty());
    EXPECT_EQ(recordedPath(std::vector<glm::dvec3>{{1, 1, 1}, {1, 1, 9}}).size(), 1U);
}

} // namespace
} // namespace vs::sculpt

// SPDX-License-Identifier: Apache-2.0
#include "render/camera/fit.h"
#include "render/camera/orbit.h"

#include "property.h"

#include <array>
#include <cmath>
#include <vector>

namespace vs::render {
namespace {

constexpr double kMostZoom = 100;

volume::GridGeometry grid() { return volume::makeGeometry({128, 128, 299}, {2.0, 2.0, 3.0}); }

double uniform(double lo, double hi) { return *test::between(lo, hi); }

Camera anyCamera() {
    Camera camera{
        uniform(-180, 180), uniform(-90, 90), uniform(0.3, 3), {uniform(-50, 50), uniform(-50, 50)}};
    camera.projection = *test::coin() ? Projection::Perspective : Projection::Orthographic;
    camera.rollDegrees = uniform(-180, 180);
    return camera;
}

double largestDifference(const glm::dmat3& a, const glm::dmat3& b) {
    double most = 0;
    for (int n = 0; n < 9; ++n) {
        most = std::max(most, std::abs(a[n / 3][n % 3] - b[n / 3][n % 3]));
    }
    return most;
}

TEST(CameraTest, EveryWayOfLookingHasAngles) {
    test::checkProperty(400, [] {
        const Camera camera = anyCamera();
        const Camera same = withAxes(Camera{}, viewerAxes(camera));
        RC_ASSERT(largestDifference(viewerAxes(same), viewerAxes(camera)) < 1e-12);
        RC_ASSERT(std::abs(same.elevationDegrees) <= 90);
    });
}

TEST(CameraTest, StraightFromAboveTheAzimuthStays) {
    for (const double elevation : {-90.0, 90.0}) {
        Camera camera{73, elevation};
        camera.rollDegrees = 20;
        const Camera same = withAxes(camera, viewerAxes(camera));
        EXPECT_NEAR(same.azimuthDegrees, 73, 1e-9);
        EXPECT_NEAR(same.rollDegrees, 20, 1e-9);
    }
}

// What the hand takes hold of on the side that it sees goes with it: the middle of a ball's front.
TEST(CameraTest, WhatIsSeenTurnsWithTheHand) {
    test::checkProperty(400, [] {
        const Camera before = anyCamera();
        const glm::dvec2 hand{uniform(-1, 1), uniform(-1, 1)}; // to the right and down
        RC_PRE(glm::length(hand) > 0.01);
        const Camera after = tumbled(before, glm::dvec3(hand.y, hand.x, 0));
        const glm::dvec3 front = viewerAxes(before)[2];
        const glm::dvec3 seen = glm::transpose(viewerAxes(after)) * front;
        const double angle = glm::radians(glm::length(hand));
        RC_ASSERT(std::abs(seen.x - std::sin(angle) * hand.x / glm::length(hand)) < 1e-9);
        RC_ASSERT(std::abs(-seen.y - std::sin(angle) * hand.y / glm::length(hand)) < 1e-9);
    });
}

TEST(CameraTest, TumblesPastThePoles) {
    Camera camera;
    for (int n = 0; n < 36; ++n) {
        const Camera next = tumbled(camera, {10, 0, 0}); // down
        EXPECT_NEAR(glm::dot(viewerAxes(camera)[2], viewerAxes(next)[2]), std::cos(glm::radians(10.0)), 1e-9);
        camera = next;
    }
    EXPECT_LT(largestDifference(viewerAxes(camera), viewerAxes(Camera{})), 1e-9) << "once around";
}

TEST(CameraTest, StandardViewsAreAsBooksHaveThem) {
    const glm::dvec3 left{1, 0, 0};
    const glm::dvec3 posterior{0, 1, 0};
    const glm::dvec3 superior{0, 0, 1};
    const auto axes = [](glm::dvec3 from) { return viewerAxes(lookingFrom(Camera{12, 34, 1, {}}, from)); };
    EXPECT_LT(largestDifference(axes(-posterior), {left, superior, -posterior}), 1e-12) << "the face";
    EXPECT_LT(largestDifference(axes(posterior), {-left, superior, posterior}), 1e-12) << "from behind";
    EXPECT_LT(largestDifference(axes(left), {posterior, superior, left}), 1e-12);
    EXPECT_LT(largestDifference(axes(-left), {-posterior, superior, -left}), 1e-12);
    EXPECT_LT(largestDifference(axes(superior), {-left, -posterior, superior}), 1e-12) << "anterior up";
    EXPECT_LT(largestDifference(axes(-superior), {left, -posterior, -superior}), 1e-12)
        << "as axial slices, anterior up and left on the right";
}

TEST(CameraTest, ThePivotStaysWhereItIsSeen) {
    test::checkProperty(400, [] {
        const auto geometry = grid();
        const Camera before = anyCamera();
        const glm::dvec3 pivot =
            geometry.centreWorld() + glm::dvec3(uniform(-40, 40), uniform(-40, 40), uniform(-40, 40));
        const Camera turned = tumbled(before, {uniform(-90, 90), uniform(-90, 90), uniform(-90, 90)});
        const Camera after = aroundPivot(before, turned, pivot, geometry, kMostZoom);
        const glm::ivec2 size{800, 600};
        const auto from = viewRays(before, geometry, size);
        const auto to = viewRays(after, geometry, size);
        RC_ASSERT(glm::distance(from.project(pivot), to.project(pivot)) < 1e-6);
        RC_ASSERT(std::abs(from.pixelMm(pivot) / to.pixelMm(pivot) - 1) < 1e-9);
        RC_ASSERT(largestDifference(viewerAxes(after), viewerAxes(turned)) == 0);
    });
}

// All points are in the picture less its margins, and they touch two opposite margins: none is larger.
TEST(CameraTest, WhatIsFittedFillsThePicture) {
    test::checkProperty(400, [] {
        const auto geometry = grid();
        const Camera before = anyCamera();
        const glm::ivec2 size = std::array{glm::ivec2(800, 600), glm::ivec2(300, 900),
                                           glm::ivec2(64, 64)}[std::size_t(*test::below(3))];
        const glm::dvec3 middle =
            geometry.centreWorld() + glm::dvec3(uniform(-60, 60), uniform(-60, 60), uniform(-200, 200));
        std::vector<glm::dvec3> points;
        for (int n = 0; n < 40; ++n) {
            points.push_back(middle + glm::dvec3(uniform(-80, 80), uniform(-60, 60), uniform(-150, 150)));
        }
        constexpr double margin = 0.05;
        const Camera fit = fitted(before, geometry, size, points, margin, kMostZoom);
        RC_ASSERT(largestDifference(viewerAxes(fit), viewerAxes(before)) == 0);
        glm::dvec2 lo(1e9);
        glm::dvec2 hi(-1e9);
        const auto rays = viewRays(fit, geometry, size);
        for (const glm::dvec3 point : points) {
            const glm::dvec2 seen = rays.project(point) / glm::dvec2(size);
            lo = glm::min(lo, seen);
            hi = glm::max(hi, seen);
        }
        const glm::dvec2 room = glm::min(lo, 1.0 - hi);
        RC_ASSERT(std::abs(std::min(room.x, room.y) - margin) < 1e-6);
        const glm::dvec2 left = glm::abs(lo - (1.0 - hi)); // in its middle
        RC_ASSERT(std::min(left.x, left.y) < 1e-6);
        RC_ASSERT((room.x < room.y ? left.x : left.y) < 1e-6);
    });
}

TEST(CameraTest, WithoutPointsNothingIsFitted) {
    const Camera camera{10, 20, 3, {4, 5}};
    EXPECT_EQ(fitted(camera, grid(), {640, 480}, {}, 0.04, kMostZoom), camera);
}

TEST(CameraTest, OnePointIsLookedAt) {
    const std::vector<glm::dvec3> points{grid().centreWorld() + glm::dvec3(10, 20, 30)};
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        Camera camera;
        camera.projection = projection;
        const auto rays =
            viewRays(fitted(camera, grid(), {640, 480}, points, 0.04, kMostZoom), grid(), {640, 480});
        EXPECT_LT(glm::distance(rays.project(points.front()), glm::dvec2(320, 240)), 1.0);
    }
}

} // namespace
} // namespace vs::render

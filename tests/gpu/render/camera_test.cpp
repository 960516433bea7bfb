// SPDX-License-Identifier: Apache-2.0
#include "render/camera/camera.h"

#include <gtest/gtest.h>

namespace vs::render {
namespace {

const volume::GridGeometry kGrid = volume::makeGeometry({100, 120, 80}, {1, 1, 2});

TEST(Camera, AzimuthZeroLooksAtTheFaceWithSuperiorUp) {
    const ViewRays rays = viewRays({}, kGrid, {200, 100});
    EXPECT_NEAR(glm::dot(rays.forward, {0, 1, 0}), 1, 1e-12) << "from anterior (-y in LPS) towards posterior";
    EXPECT_GT(rays.up.z, 0);
    EXPECT_LT(rays.project(kGrid.centreWorld() + glm::dvec3(0, 0, 10)).y, 50) << "superior is up";
    EXPECT_GT(rays.project(kGrid.centreWorld() + glm::dvec3(10, 0, 0)).x, 100)
        << "the patient's left is on the right";
}

TEST(Camera, PositiveAnglesMoveTheViewerLeftAndUp) {
    Camera camera;
    camera.azimuthDegrees = 90;
    EXPECT_GT(viewRays(camera, kGrid, {100, 100}).eye.x, kGrid.centreWorld().x + 50);
    camera = {};
    camera.elevationDegrees = 90;
    EXPECT_GT(viewRays(camera, kGrid, {100, 100}).eye.z, kGrid.centreWorld().z + 50);
}

TEST(Camera, RollTurnsThePictureClockwiseAboutItsMiddle) {
    Camera camera;
    camera.rollDegrees = 90;
    const ViewRays rays = viewRays(camera, kGrid, {200, 200});
    const auto centre = kGrid.centreWorld();
    EXPECT_GT(rays.project(centre + glm::dvec3(0, 0, 10)).x, 101) << "superior goes to the right";
    EXPECT_GT(rays.project(centre + glm::dvec3(10, 0, 0)).y, 101) << "the patient's left goes down";
    EXPECT_NEAR(glm::length(rays.project(centre) - glm::dvec2(100)), 0, 1e-9);
}

TEST(Camera, RaysAndProjectionAreInverse) {
    for (const auto projection : {Projection::Perspective, Projection::Orthographic}) {
        Camera camera{33, -21, 1.7, {5, -8}, projection, 40};
        const ViewRays rays = viewRays(camera, kGrid, {321, 123});
        for (const glm::dvec2 pixel : {glm::dvec2{0.5, 0.5}, {160.5, 61.5}, {300, 20}}) {
            const auto ray = rays.through(pixel);
            EXPECT_NEAR(glm::length(ray.direction), 1, 1e-12);
            for (const double distance : {200.0, 700.0}) {
                const auto back = rays.project(ray.origin + distance * ray.direction);
                EXPECT_NEAR(back.x, pixel.x, 1e-6);
                EXPECT_NEAR(back.y, pixel.y, 1e-6);
            }
        }
    }
}

TEST(Camera, PixelSizeMatchesNeighbouringRays) {
    const ViewRays rays = viewRays({}, kGrid, {400, 300});
    const auto centre = kGrid.centreWorld();
    const auto pixel = rays.project(centre + glm::dvec3(0, 0, rays.pixelMm(centre)));
    EXPECT_NEAR(pixel.y, 149, 1e-3);
}

} // namespace
} // namespace vs::render

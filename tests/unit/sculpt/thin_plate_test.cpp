// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "sculpt/surface/patch_surface.h"
#include "sculpt/surface/thin_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace vs::sculpt {
namespace {

using Height = std::function<double(double, double)>;

// Known in a ring about the middle, two cells wide.
PlateRaster ringOf(int side, const Height& height) {
    PlateRaster raster;
    raster.size = {side, side};
    const double middle = 0.5 * (side - 1);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double r = std::hypot(x - middle, y - middle);
            raster.heights.push_back(height(x - middle, y - middle));
            raster.weights.push_back(r > middle - 3 && r < middle ? 10 : 0);
        }
    }
    return raster;
}

TEST(ThinPlate, GoesOnWithHeightsAndSlopes) {
    for (const Height& height :
         {Height([](double x, double y) { return 3 + 0.2 * x - 0.1 * y; }),
          Height([](double x, double y) { return 0.01 * (x * x + y * y); }),
          Height([](double x, double y) { return 0.02 * x * y + 0.01 * (x * x - y * y); })}) {
        const PlateRaster known = ringOf(31, height);
        const auto plate = thinPlate(known);
        for (int y = 0; y < 31; ++y) {
            for (int x = 0; x < 31; ++x) {
                if (std::hypot(x - 15, y - 15) > 13) { // beside the ring it is free
                    continue;
                }
                // Quadratic surfaces bend evenly: a plate with their tangents is they themselves.
                EXPECT_NEAR(plate[std::size_t(31 * y + x)], height(x - 15, y - 15), 0.05) << x << ", " << y;
            }
        }
    }
}

TEST(ThinPlate, NeedsThreePlacesThatAreInNoLine) {
    PlateRaster raster;
    raster.size = {8, 8};
    raster.heights.assign(64, 1.0);
    raster.weights.assign(64, 0.0);
    EXPECT_THROW(thinPlate(raster), Error);
    for (int i = 0; i < 8; ++i) {
        raster.weights[std::size_t(9 * i)] = 1;
    }
    EXPECT_THROW(thinPlate(raster), Error);
    raster.weights[7] = 1;
    for (const double height : thinPlate(raster)) {
        EXPECT_NEAR(height, 1, 1e-6);
    }
}

std::vector<glm::dvec3> ringOnBall(double radius, double from, double to,
                                   const std::function<double(double)>& off = {}) {
    std::vector<glm::dvec3> places;
    for (int turn = 0; turn < 360; turn += 3) {
        for (double r = from; r < to; r += 0.5) {
            const double a = turn * 3.14159265358979 / 180;
            const double depth = off ? off(a) : 0.0;
            places.emplace_back(r * std::cos(a), r * std::sin(a), std::sqrt(radius * radius - r * r) - depth);
        }
    }
    return places;
}

TEST(PatchSurface, ClosesAHoleInABall) {
    const PatchSurface surface(ringOnBall(60, 14, 18), {0, 0, 1}, 1);
    for (int i = -10; i <= 10; ++i) {
        const double r = 1.2 * i;
        EXPECT_NEAR(surface.depthOf({r, 0, std::sqrt(3600 - r * r)}), 0, 0.1) << r;
        EXPECT_NEAR(surface.depthOf(glm::dvec3(0, r, std::sqrt(3600 - r * r)) * (58.0 / 60)), 2, 0.12) << r;
    }
}

// Furrows that run into the hole do not pull the surface down with them.
TEST(PatchSurface, IsNotLedByFurrows) {
    const auto furrow = [](double turn) { return std::cos(5 * turn) > 0.75 ? 5.0 : 0.0; };
    const PatchSurface surface(ringOnBall(60, 14, 18, furrow), {0, 0, 1}, 1);
    for (int i = -5; i <= 5; ++i) {
        EXPECT_NEAR(surface.depthOf({2.0 * i, 0, std::sqrt(3600 - 4.0 * i * i)}), 0, 1.0) << i;
    }
}

TEST(PatchSurface, WantsSurfaceOnAllSides) {
    std::vector<glm::dvec3> half;
    for (const glm::dvec3& place : ringOnBall(60, 14, 18)) {
        if (place.x > 0) {
            half.push_back(place);
        }
    }
    EXPECT_THROW(PatchSurface(half, {0, 0, 1}, 1), Error);
    EXPECT_THROW(PatchSurface({}, {0, 0, 1}, 1), Error);
}

} // namespace
} // namespace vs::sculpt

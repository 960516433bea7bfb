// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/surface_area.h"

#include "masks.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace vs::segment {
namespace {

constexpr glm::dvec3 kCubic{1.0};
constexpr glm::dvec3 kFlat{1, 1, 3};

double areaOf(const volume::GridGeometry& grid, const std::function<int(glm::dvec3)>& label) {
    return surfaceAreas(grid, labelsWhere(grid, label))[1];
}

double relativeError(double area, double truth) { return area / truth - 1; }

glm::dmat3 turned(double angle, glm::dvec3 axis) {
    return glm::dmat3(glm::rotate(glm::dmat4(1), angle, glm::normalize(axis)));
}

// Surface of an ellipsoid by quadrature over its parameters.
double ellipsoidArea(glm::dvec3 radii) {
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double theta = glm::pi<double>() * (i + 0.5) / steps;
            const double phi = 2 * glm::pi<double>() * (j + 0.5) / steps;
            const glm::dvec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta));
            sum += std::sin(theta) * glm::length(n / radii);
        }
    }
    return sum * radii.x * radii.y * radii.z * 2 * glm::pi<double>() * glm::pi<double>() / (steps * steps);
}

double ballError(double radius, glm::dvec3 spacing) {
    const double area = areaOf(centredGrid(2 * radius + 4, spacing),
                               [&](glm::dvec3 p) { return isInEllipsoid(p, glm::dvec3(radius)); });
    return relativeError(area, 4 * glm::pi<double>() * radius * radius);
}

TEST(SurfaceArea, OfBalls) {
    // What stairs the smoothing leaves is left on cubic voxels too; flat ones have higher stairs.
    EXPECT_NEAR(ballError(20, kCubic), 0, 0.01);
    EXPECT_NEAR(ballError(8, kCubic), 0, 0.01);
    EXPECT_NEAR(ballError(4, kCubic), 0, 0.01);
    EXPECT_NEAR(ballError(20, kFlat), 0, 0.02);
    EXPECT_NEAR(ballError(20, 0.5 * kFlat), 0, 0.02);
    EXPECT_NEAR(ballError(20, {0.6, 1, 2}), 0, 0.02);
}

TEST(SurfaceArea, OfTurnedEllipsoids) {
    const glm::dvec3 radii(24, 15, 10);
    for (const double angle : {0.0, 0.4, 0.9, 1.3}) {
        const auto turn = turned(angle, {1, 2, 0.5});
        const auto label = [&](glm::dvec3 p) { return isInEllipsoid(turn * p, radii); };
        const double truth = ellipsoidArea(radii);
        EXPECT_NEAR(relativeError(areaOf(centredGrid(52, kCubic), label), truth), 0, 0.01) << angle;
        // Surfaces that rise slowly through flat voxels have stairs longer than the smoothing.
        EXPECT_NEAR(relativeError(areaOf(centredGrid(52, kFlat), label), truth), 0, 0.04) << angle;
    }
}

TEST(SurfaceArea, OfTurnedBoxesLacksSomeOfTheEdgesOnly) {
    const glm::dvec3 half(20, 15, 12);
    const double truth = 8 * (half.x * half.y + half.y * half.z + half.z * half.x);
    const double edges = 8 * (half.x + half.y + half.z);
    for (const double angle : {0.0, 0.3, 0.7, 1.1}) {
        const auto turn = turned(angle, {0.3, 1, 2});
        const auto label = [&](glm::dvec3 p) { return isInBox(turn * p, half); };
        const double cubic = areaOf(centredGrid(60, kCubic), label) - truth;
        EXPECT_LT(cubic, 0) << angle;
        EXPECT_GT(cubic, -0.6 * edges) << angle; // mm^2 a mm: the width that a rounded edge saves
        EXPECT_NEAR(relativeError(areaOf(centredGrid(60, kFlat), label), truth), 0, 0.06) << angle;
    }
}

// A flat face far from its edges is exact, however the voxels are shaped.
TEST(SurfaceArea, OfFacesAlongTheGridIsExact) {
    const auto grow = [](int size) {
        const auto grid = volume::makeGeometry({70, 40, 30}, {0.7, 1, 2.5});
        return surfaceAreas(grid, labelsWhere(grid, [&](glm::dvec3 p) {
                                return p.x < 0.7 * (size - 0.5) && p.y > 9.5 && p.y < 30.5 && p.z > 20 &&
                                       p.z < 50;
                            }))[1];
    };
    // Ten voxels more along x: four sides of 7 mm more, their edges lose the same again.
    const double sides = 7 * 2 * (21 + 11 * 2.5);
    const double perMm = (grow(60) - grow(50)) / 7;
    EXPECT_NEAR((grow(50) - grow(40)) / 7, perMm, 1e-9);
    EXPECT_LT(7 * perMm, sides);
    EXPECT_GT(7 * perMm, sides - 7 * 4 * 1.5);
}

TEST(SurfaceArea, DoesNotDependOnPlaceHandednessOrNeighbours) {
    const auto ball = [](glm::dvec3 p, glm::dvec3 c) { return isInEllipsoid(p - c, glm::dvec3(9)); };
    auto grid = volume::makeGeometry({140, 60, 60}, {1, 1, 1.5});
    const auto two =
        surfaceAreas(grid, labelsWhere(grid, [&](glm::dvec3 p) {
                         return ball(p, {50, 20, 30}) ? 7 : p.x < 100 ? 0 : ball(p, {112, 37, 51}) ? 9 : 3;
                     }));
    EXPECT_EQ(two[0], 0);
    EXPECT_EQ(two[1], 0);
    EXPECT_NEAR(two[7], two[9], 1e-6 * two[7]);
    const double outside = 2 * (40.0 * 60 + 60 * 90 + 90 * 40);
    EXPECT_NEAR(two[3], outside + two[9], 0.04 * outside); // the border of the grid closes it
    const auto labels = labelsWhere(grid, [&](glm::dvec3 p) { return ball(p, {50, 20, 30}) ? 7 : 0; });
    grid.worldFromVoxel = glm::translate(glm::dmat4(turned(0.7, {1, 2, 3})), {5, -70, 9}) *
                          glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1.5));
    EXPECT_NEAR(surfaceAreas(grid, labels)[7], two[7], 1e-6 * two[7]);
}

// Nothing thin may vanish: one voxel has its six faces, a sheet both its sides, half of a voxel's rounding
// aside.
TEST(SurfaceArea, OfSingleVoxelsAndSheets) {
    const auto grid = volume::makeGeometry({50, 50, 9}, {1, 2, 3});
    const double voxel =
        surfaceAreas(grid, labelsWhere(grid, [](glm::dvec3 p) { return p == glm::dvec3(20, 40, 12); }))[1];
    EXPECT_NEAR(voxel, 22, 1e-9);
    const double sheet = surfaceAreas(grid, labelsWhere(grid, [](glm::dvec3 p) { return p.z == 12; }))[1];
    EXPECT_NEAR(sheet, 2 * 50 * 100, 0.1 * 2 * 50 * 100);
}

} // namespace
} // namespace vs::segment

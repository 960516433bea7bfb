// SPDX-License-Identifier: Apache-2.0
// Vessels in voxels that are three times as thick as wide: rings, stenoses, branches. And loops, where more
// than one way leads from voxel to voxel.
#include "tubes.h"

#include "segment/measures/narrowest.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace vs::segment {
namespace {

const glm::dvec3 kThickSlices(1, 1, 3);

double meanDiameterMm(const Vessel& vessel) {
    double sum = 0;
    for (const VesselPoint& point : vessel.points) {
        sum += point.diameterMm;
    }
    return sum / double(vessel.points.size());
}

TEST(FlatVessel, MeansAreWithinOnePercentOfManyTubes) {
    double sum = 0;
    double worst = 0;
    int count = 0;
    for (const double radius : {4.0, 5.0, 8.0}) {
        for (const glm::dvec3 direction : {glm::dvec3(1, 2, 3), {-3, 1, 0.4}, {0.2, -1, 0.1}, {1, 1, -1}}) {
            const auto tube = straight(direction, radius, 25);
            const Errors e = measuredAlong(tube, centredGrid(56, kThickSlices));
            const double part = e.meanDiameter / (2 * radius);
            sum += part;
            worst = std::max(worst, std::abs(part));
            ++count;
        }
    }
    EXPECT_LT(std::abs(sum / count), 0.01);
    EXPECT_LT(worst, 0.03); // one mask has room for more than one tube
}

TEST(FlatVessel, Rings) {
    const double radius = 4;
    const double bend = 20;
    const auto grid = centredGrid(2 * (radius + bend) + 12, kThickSlices);
    const auto turn = glm::dmat3(glm::rotate(glm::dmat4(1), 0.6, glm::normalize(glm::dvec3(1, 2, 0.5))));
    const auto tube = [&](glm::dvec3 place) {
        const glm::dvec3 p = place * turn;
        return std::hypot(std::hypot(p.x, p.y) - bend, p.z) < radius && (p.x > 0 || p.y > 0);
    };
    const auto at = [&](double angle) {
        return voxelAt(grid, turn * (bend * glm::dvec3(std::cos(angle), std::sin(angle), 0)));
    };
    const Vessel vessel = vesselBetween(setWhere(grid, tube), grid, at(0), at(glm::half_pi<double>()));
    for (const VesselPoint& point : vessel.points) {
        EXPECT_NEAR(point.diameterMm, 2 * radius, 0.5);
    }
    EXPECT_NEAR(meanDiameterMm(vessel), 2 * radius, 0.02 * 2 * radius);
}

TEST(FlatVessel, Stenoses) {
    const auto grid = centredGrid(80, kThickSlices);
    Straight tube = straight({1, 2, 1.5}, 5, 40);
    tube.radius = [](double along) {
        const double turns = along / 25;
        return 5 - (std::abs(turns) < 0.5 ? 1.25 * (1 + std::cos(glm::two_pi<double>() * turns)) : 0);
    };
    const auto at = [&](double along) { return voxelAt(grid, along * tube.direction); };
    const auto narrowest = narrowestOf(vesselBetween(setWhere(grid, tube), grid, at(-33), at(33)));
    ASSERT_TRUE(narrowest);
    EXPECT_NEAR(narrowest->diameterMm, 5, 0.5);
    EXPECT_NEAR(narrowest->referenceDiameterMm, 10, 0.3);
    EXPECT_NEAR(narrowest->stenosisPercent, 50, 6); // 0.5 and 0.3 of 10
}

TEST(FlatVessel, BranchesDoNotWidenIt) {
    const auto grid = centredGrid(56, kThickSlices);
    const auto tube = straight({1, 0.4, 0.3}, 5, 26);
    auto branch = straight({-0.3, 1, 0.5}, 2.5, 8);
    branch.middle = 8.0 * branch.direction;
    const auto set = setWhere(grid, [&](glm::dvec3 place) { return tube(place) || branch(place); });
    EXPECT_LT(measuredAlong(tube, grid, set).diameter, 1); // of 10: the branch is 5 wide
}

// A ring in the plane z = 0 whose two halves, y > 0 and y < 0, can be of different width and length.
struct Loop {
    double upper, lower;   // radii of the tube
    glm::dvec2 stretch{1}; // of the upper and the lower half along y

    [[nodiscard]] bool operator()(glm::dvec3 p) const {
        const double side = p.y > 0 ? stretch.x : stretch.y;
        const double ring = std::hypot(p.x, p.y / side) - 18;
        return std::hypot(ring, p.z) < (p.y > 0 ? upper : lower);
    }
};
// Whether the way from one side of a loop to the other goes above.
bool goesAbove(const Loop& loop, const glm::dvec3& spacing) {
    const auto grid = centredGrid(92, spacing);
    const auto at = [&](double x) { return voxelAt(grid, {x, 0, 0}); };
    const Vessel vessel = vesselBetween(setWhere(grid, loop), grid, at(-18), at(18));
    return worldAt(grid, vessel.points[vessel.points.size() / 2].voxel).y > 0;
}

TEST(Loops, WiderAndShorterWaysWin) {
    for (const glm::dvec3 spacing : {glm::dvec3(1), kThickSlices}) {
        EXPECT_TRUE(goesAbove({5, 3.5}, spacing));
        EXPECT_FALSE(goesAbove({3.5, 5}, spacing));
        EXPECT_TRUE(goesAbove({4, 4, {1, 2}}, spacing)) << "the shorter one of two as wide";
        EXPECT_FALSE(goesAbove({4, 4, {2, 1}}, spacing));
        EXPECT_FALSE(goesAbove({3, 6, {1, 2}}, spacing)) << "the wider one though it is longer";
    }
}

} // namespace
} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
// Vessels measured between two voxels against tubes whose axes, lengths and diameters are known. Lengths are
// in steps (the smallest spacing) where nothing else is said.
#include "segment/measures/narrowest.h"

#include "base/error.h"
#include "property.h"
#include "tubes.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace vs::segment {
namespace {

// From a radius of 4 steps on, single diameters are as good as 0.2 steps wherever the mask tells them: not
// along the grid, where all slices are alike and circles that differ by more can have one mask.
TEST(Vessel, StraightTubesAcrossTheGrid) {
    for (const double radius : {4.0, 5.0, 8.0}) {
        for (const glm::dvec3 direction : {glm::dvec3(1, 2, 3), {-3, 1, 0.4}, {0.2, -1, 0.1}, {1, 1, -1}}) {
            const auto grid = centredGrid(60, glm::dvec3(1));
            const Errors e = measuredAlong(straight(direction, radius, 30), grid);
            EXPECT_LT(e.diameter, 0.2) << radius;
            EXPECT_LT(e.axis, 0.2) << radius;
            EXPECT_LT(e.length, 0.2) << radius;
        }
    }
}

TEST(Vessel, FlatAndTurnedVoxels) {
    const glm::dvec3 direction(1, 2, 3);
    for (const double radius : {4.0, 5.0, 8.0}) {
        const Errors flat = measuredAlong(straight(direction, radius, 30), centredGrid(60, {1, 1, 3}));
        EXPECT_LT(flat.diameter, 0.3) << radius; // a diameter of 8 is less than three slices
        EXPECT_LT(flat.axis, 0.2) << radius;
        EXPECT_LT(flat.length, 0.2) << radius;
    }
    for (const double radius : {6.0, 8.0}) {
        const auto grid = turnedGrid(24, {0.4, 0.7, 2});
        const Errors e = measuredAlong(straight(direction, 0.4 * radius, 12), grid);
        EXPECT_LT(e.diameter, 0.35) << radius; // which is 0.14 mm where slices are 2 mm apart
        EXPECT_LT(std::abs(e.meanDiameter), 0.1) << radius;
        EXPECT_LT(e.axis, 0.2) << radius;
        EXPECT_LT(e.length, 0.3) << radius;
    }
}

TEST(Vessel, TubesAnyhow) {
    test::checkProperty(25, [] {
        const auto tilt = [] { return *test::between(-1, 1); };
        const glm::dvec3 direction(tilt(), tilt(), 0.3 + *test::between(0, 1));
        const double radius = *test::between(3, 8);
        auto tube = straight(direction, radius, 20);
        tube.middle = {*test::between(0, 1), *test::between(0, 1), *test::between(0, 1)};
        const Errors e = measuredAlong(tube, centredGrid(42, glm::dvec3(1)));
        RC_ASSERT(e.diameter < 0.45); // along the grid one mask fits circles that differ by up to that
        RC_ASSERT(e.axis < 0.25);
        RC_ASSERT(e.length < 0.2);
    });
}

// Voxels at the wall that were taken or left by chance: the mean stays, single values are as good as chance
// lets them be.
TEST(Vessel, RaggedTubes) {
    const auto grid = centredGrid(60, glm::dvec3(1));
    const auto tube = straight({1, 2, 3}, 5, 30);
    VoxelSet set = setWhere(grid, tube);
    std::mt19937 random(1);
    forEachVoxel(grid.box(), [&](glm::ivec3 voxel, std::size_t i) {
        const bool isAtWall = std::abs(tube.off(worldAt(grid, glm::dvec3(voxel))) - 5) < 0.5;
        set.inside[i] ^= std::uint8_t(isAtWall && random() % 100 < 15 ? 1 : 0);
    });
    const Errors e = measuredAlong(tube, grid, set);
    EXPECT_LT(std::abs(e.meanDiameter), 0.1);
    EXPECT_LT(e.diameter, 0.5);
    EXPECT_LT(e.length, 0.2);
}

TEST(Vessel, Rings) {
    for (const double bend : {3.0, 5.0, 10.0}) { // radii of the tube
        const double radius = 4;
        const auto grid = centredGrid(2 * radius * (bend + 1) + 8, glm::dvec3(1));
        const auto turn = glm::dmat3(glm::rotate(glm::dmat4(1), 0.6, glm::normalize(glm::dvec3(1, 2, 0.5))));
        const auto tube = [&](glm::dvec3 place) {
            const glm::dvec3 p = place * turn;
            const double ring = std::hypot(p.x, p.y) - bend * radius;
            return std::hypot(ring, p.z) < radius && (p.x > 0 || p.y > 0); // three quarters
        };
        const auto at = [&](double angle) {
            return voxelAt(grid, turn * (bend * radius * glm::dvec3(std::cos(angle), std::sin(angle), 0)));
        };
        const Vessel vessel = vesselBetween(setWhere(grid, tube), grid, at(0), at(glm::half_pi<double>()));
        double axis = 0;
        for (const VesselPoint& point : vessel.points) {
            const glm::dvec3 p = worldAt(grid, point.voxel) * turn;
            axis += std::hypot(std::hypot(p.x, p.y) - bend * radius, p.z) / double(vessel.points.size());
            EXPECT_NEAR(point.diameterMm, 2 * radius, 0.25) << bend;
        }
        EXPECT_LT(axis, 0.1) << bend;
        // The clicks lie on voxels, half a diagonal from the angles that were meant.
        EXPECT_NEAR(vessel.lengthMm, glm::half_pi<double>() * bend * radius, 1.8) << bend;
    }
}

TEST(Vessel, StenosesAreFoundWhereTheyAre) {
    for (const double narrowing : {0.3, 0.5, 0.7}) {
        const auto grid = centredGrid(90, glm::dvec3(1));
        Straight tube = straight({1, 2, 3}, 5, 45);
        tube.radius = [narrowing](double along) {
            const double turns = along / 25;
            const double depth = 0.5 * (1 + std::cos(glm::two_pi<double>() * turns));
            return 5 * (std::abs(turns) < 0.5 ? 1 - narrowing * depth : 1);
        };
        const auto at = [&](double along) { return voxelAt(grid, along * tube.direction); };
        const Vessel vessel = vesselBetween(setWhere(grid, tube), grid, at(-38), at(38));
        const auto narrowest = narrowestOf(vessel);
        ASSERT_TRUE(narrowest);
        EXPECT_NEAR(tube.along(worldAt(grid, vessel.points[narrowest->index].voxel)), 0, 1);
        EXPECT_NEAR(narrowest->diameterMm, 10 * (1 - narrowing), 0.25);
        EXPECT_NEAR(narrowest->referenceDiameterMm, 10, 0.2);
        EXPECT_NEAR(narrowest->stenosisPercent, 100 * narrowing, 3); // 0.25 and 0.2 of 10
    }
}

TEST(Vessel, BranchesAndNeighboursDoNotWidenIt) {
    const auto grid = centredGrid(60, glm::dvec3(1));
    const auto tube = straight({1, 0.4, 0.3}, 5, 28);
    auto branch = straight({-0.3, 1, 0.5}, 2.5, 8);
    branch.middle = 8.0 * branch.direction;
    const auto withBranch = setWhere(grid, [&](glm::dvec3 place) { return tube(place) || branch(place); });
    EXPECT_LT(measuredAlong(tube, grid, withBranch).diameter, 0.5); // of 10: the branch is 5 wide
    auto neighbour = tube;
    const auto across = glm::normalize(glm::cross(tube.direction, glm::dvec3(0, 0, 1)));
    neighbour.middle = 12.0 * across;
    const auto withNeighbour =
        setWhere(grid, [&](glm::dvec3 place) { return tube(place) || neighbour(place); });
    EXPECT_LT(measuredAlong(tube, grid, withNeighbour).diameter, 0.2);
    neighbour.middle = 10.3 * across; // which touches it along all of its way
    const auto touching = setWhere(grid, [&](glm::dvec3 place) { return tube(place) || neighbour(place); });
    EXPECT_LT(measuredAlong(tube, grid, touching).diameter, 0.5);
}

// Two branches of a trunk: well before and behind the fork each has its own diameter.
TEST(Vessel, Forks) {
    const auto grid = centredGrid(80, glm::dvec3(1));
    std::array<Straight, 3> tubes{straight({0, 0.1, -1}, 6, 17), straight({0.6, 0.1, 1}, 4.5, 17),
                                  straight({-0.6, 0.2, 1}, 4.5, 17)};
    for (Straight& tube : tubes) {
        tube.middle = 16.0 * tube.direction;
    }
    const auto set = setWhere(grid, [&](glm::dvec3 place) {
        return std::any_of(tubes.begin(), tubes.end(), [&](const Straight& tube) { return tube(place); });
    });
    const auto at = [&](const Straight& tube) { return voxelAt(grid, 26.0 * tube.direction); };
    for (const std::size_t limb : {1U, 2U}) {
        const Vessel vessel = vesselBetween(set, grid, at(tubes[0]), at(tubes[limb]));
        for (const VesselPoint& point : vessel.points) {
            const double fromFork = glm::length(worldAt(grid, point.voxel));
            const bool isInTrunk = point.alongMm < vessel.lengthMm / 2;
            if (fromFork > 14) {
                EXPECT_NEAR(point.diameterMm, isInTrunk ? 12 : 9, 0.4);
            }
        }
        EXPECT_NEAR(vessel.lengthMm, 52, 3); // it rounds the corner
    }
}

TEST(Vessel, ShortStretchesAndOneVoxel) {
    const auto grid = centredGrid(50, glm::dvec3(1));
    const auto tube = straight({1, 2, 3}, 5, 25);
    const auto set = setWhere(grid, tube);
    for (const double length : {0.0, 3.0, 8.0}) {
        const auto from = voxelAt(grid, {1, 1, -1});
        const auto to = voxelAt(grid, glm::dvec3(1, 1, -1) + length * tube.direction);
        const Vessel vessel = vesselBetween(set, grid, from, to);
        EXPECT_NEAR(vessel.lengthMm, glm::dot(glm::dvec3(to - from), tube.direction), 0.2);
        EXPECT_LT(errorsOf(vessel, grid, tube).diameter, 0.25);
    }
}

TEST(Vessel, SaysWhatIsWrong) {
    const auto grid = centredGrid(40, glm::dvec3(1));
    const auto set =
        setWhere(grid, [](glm::dvec3 p) { return std::abs(p.x) > 3 && std::hypot(p.y, p.z) < 4; });
    const auto on = [&](double x) { return voxelAt(grid, {x, 0, 0}); };
    const auto messageOf = [&](const VoxelSet& vessel, glm::ivec3 from, glm::ivec3 to) -> std::string {
        try {
            vesselBetween(vessel, grid, from, to);
            return "nothing";
        } catch (const Error& error) {
            return error.what();
        }
    };
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos && text.find('\n') == std::string::npos;
    };
    EXPECT_TRUE(has(messageOf(set, on(8), voxelAt(grid, {8, 12, 0})), "mm away"));
    EXPECT_TRUE(has(messageOf(set, on(-8), on(8)), "do not touch"));
    EXPECT_TRUE(has(messageOf(emptySet(grid.box()), on(8), on(15)), "empty"));
    EXPECT_EQ(messageOf(set, voxelAt(grid, {6, 5, 0}), on(15)), "nothing") << "beside it is near enough";
}

} // namespace
} // namespace vs::segment

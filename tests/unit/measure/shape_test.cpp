// SPDX-License-Identifier: Apache-2.0
// The shape of segments against closed forms, on voxels of any size and direction, and how they hang together
// against counting corners, edges, faces and blocks one by one.
#include "segment/measures/shape.h"

#include "masks.h"
#include "phantom/phantom.h"
#include "property.h"
#include "segment/edits/label_sets.h"
#include "segment/measures/statistics.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/component_wise.hpp>
#include <gtest/gtest.h>

#include <set>

namespace vs::segment {
namespace {

SegmentStatistics measured(const volume::GridGeometry& grid,
                           const std::function<bool(glm::dvec3)>& isInside) {
    const auto labels = labelsWhere(grid, [&](glm::dvec3 place) { return isInside(place) ? 1 : 0; });
    volume::Volume volume =
        phantom::makePhantom(grid.dims, volume::ScalarType::UInt8, [](glm::dvec3) { return 1.0; });
    volume.geometry = grid;
    return measure(volume, labels).at(0);
}

Topology topologyOf(glm::ivec3 dims, const std::vector<std::uint8_t>& labels, std::uint8_t of = 1) {
    return topologies(dims, labels, labelBoxes(labels, dims))[of];
}

Topology topologyWhere(const std::function<bool(glm::dvec3)>& isInside) {
    const auto grid = centredGrid(40, glm::dvec3(1));
    return topologyOf(grid.dims,
                      labelsWhere(grid, [&](glm::dvec3 place) { return isInside(place) ? 1 : 0; }));
}

// The half edges of the ellipsoid with the moments of a box are sqrt(5 / 3) of the box's.
TEST(Shape, AxesOfABoxAreExactOnAnyVoxels) {
    for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 3), glm::dvec3(0.3, 0.7, 0.5)}) {
        volume::GridGeometry grid = volume::makeGeometry({40, 40, 40}, spacing);
        const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, -1)));
        grid.worldFromVoxel = turned * grid.worldFromVoxel;
        const glm::ivec3 size(30, 12, 20);
        const glm::dmat4 voxelFromWorld = glm::inverse(grid.worldFromVoxel);
        const auto s = measured(grid, [&](glm::dvec3 place) {
            const glm::dvec3 voxel(voxelFromWorld * glm::dvec4(place, 1));
            return glm::all(glm::greaterThan(voxel, glm::dvec3(3.5))) &&
                   glm::all(glm::lessThan(voxel, glm::dvec3(size) + 3.5));
        });
        std::array<std::pair<double, int>, 3> edges;
        for (int axis = 0; axis < 3; ++axis) {
            edges[std::size_t(axis)] = {size[axis] * spacing[axis], axis};
        }
        std::sort(edges.rbegin(), edges.rend());
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(s.axes[i].lengthMm, std::sqrt(5.0 / 3) * edges[i].first, 1e-9);
            const glm::dvec3 direction(turned[edges[i].second]);
            EXPECT_NEAR(std::abs(glm::dot(s.axes[i].direction, direction)), 1, 1e-9);
            const auto size3 = glm::abs(s.axes[i].direction);
            EXPECT_GT(
                glm::dot(s.axes[i].direction, glm::dvec3(glm::equal(size3, glm::dvec3(glm::compMax(size3))))),
                0);
        }
    }
}

TEST(Shape, AxesAndSphericityOfEllipsoids) {
    for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 3)}) {
        const auto grid = centredGrid(110, spacing);
        const glm::dvec3 radii(45, 30, 18);
        const auto ellipsoid = measured(grid, [&](glm::dvec3 place) { return isInEllipsoid(place, radii); });
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(ellipsoid.axes[i].lengthMm / (2 * radii[int(i)]), 1, 0.01);
            EXPECT_NEAR(std::abs(ellipsoid.axes[i].direction[int(i)]), 1, 0.001);
        }
        // Thomsen's formula is good to 1 % for the surface of an ellipsoid.
        const double p = 1.6075;
        const auto pair = [&](int a, int b) { return std::pow(radii[a] * radii[b], p); };
        const double surface =
            4 * glm::pi<double>() * std::pow((pair(0, 1) + pair(0, 2) + pair(1, 2)) / 3, 1 / p);
        const double ml = 4.0 / 3 * glm::pi<double>() * radii.x * radii.y * radii.z / 1000;
        const double least = spacing.z > 1 ? 0.05 : 0.02; // surfaces are as good as that, see surface_area.h
        EXPECT_NEAR(ellipsoid.sphericity / sphericity(ml, surface), 1, least);
        const auto ball = measured(grid, [](glm::dvec3 place) { return glm::length(place) < 40; });
        EXPECT_NEAR(ball.sphericity, 1, least);
        EXPECT_LT(ellipsoid.sphericity, ball.sphericity);
    }
    EXPECT_NEAR(sphericity(1, 600), std::cbrt(glm::pi<double>() / 6), 1e-12) << "a cube of 10 mm";
}

TEST(Shape, KnownSolidsHangTogetherAsTheyDo) {
    const auto ball = [](glm::dvec3 p, glm::dvec3 at, double r) { return glm::distance(p, at) < r; };
    const auto ring = [](glm::dvec3 p, glm::dvec3 at) {
        p -= at;
        return std::hypot(std::hypot(p.x, p.y) - 7, p.z) < 2.5;
    };
    EXPECT_EQ(topologyWhere([&](glm::dvec3 p) { return ball(p, {0, 0, 0}, 12); }), (Topology{1, 1, 0}));
    EXPECT_EQ(topologyWhere([&](glm::dvec3 p) { return ring(p, {0, 0, 0}); }), (Topology{0, 1, 0}));
    EXPECT_EQ(topologyWhere([&](glm::dvec3 p) {
                  return ring(p, {-7, 0, 0}) || ring(p, {7, 0, 0});
              }),
              (Topology{-1, 1, 0}))
        << "an eight has two tunnels";
    const auto hollow = topologyWhere([&](glm::dvec3 p) {
        return ball(p, {0, 0, 0}, 12) && !ball(p, {0, 0, 0}, 5);
    });
    EXPECT_EQ(hollow, (Topology{2, 1, 1}));
    const auto all = topologyWhere([&](glm::dvec3 p) {
        return ring(p, {0, 0, -10}) || (ball(p, {0, 0, 9}, 9) && !ball(p, {0, 0, 9}, 4)) ||
               ball(p, {0, 0, 9}, 2);
    });
    EXPECT_EQ(all, (Topology{0 + 2 + 1, 3, 1}));
    EXPECT_EQ(all.tunnels(), 1);
}

TEST(Shape, WhatFillsTheGridIsOneBlock) {
    EXPECT_EQ(topologyOf({3, 1, 2}, std::vector<std::uint8_t>(6, 1)), (Topology{1, 1, 0}));
    EXPECT_EQ(topologyOf({3, 1, 2}, std::vector<std::uint8_t>(6, 0)), Topology{});
}

// Corners, edges, faces and blocks of the union, in a set of places at twice the resolution.
std::int64_t eulerOneByOne(glm::ivec3 dims, const std::vector<std::uint8_t>& labels, std::uint8_t of) {
    std::set<std::array<int, 3>> cells;
    std::size_t i = 0;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x, ++i) {
                for (int n = 0; labels[i] == of && n < 27; ++n) {
                    cells.insert({2 * x + n % 3, 2 * y + n / 3 % 3, 2 * z + n / 9});
                }
            }
        }
    }
    std::int64_t euler = 0;
    for (const auto& [x, y, z] : cells) {
        euler += (x % 2 + y % 2 + z % 2) % 2 == 0 ? 1 : -1; // odd along as many axes as it has dimensions
    }
    return euler;
}

TEST(Shape, EulerNumbersOfAnythingAreCounted) {
    test::checkProperty(300, [] {
        const glm::ivec3 dims(*rc::gen::inRange(1, 7), *rc::gen::inRange(1, 7), *rc::gen::inRange(1, 7));
        const auto voxels = std::size_t(dims.x * dims.y * dims.z);
        const auto labels =
            *rc::gen::container<std::vector<std::uint8_t>>(voxels, rc::gen::inRange<std::uint8_t>(0, 3));
        for (const std::uint8_t label : {1, 2}) {
            const Topology found = topologyOf(dims, labels, label);
            RC_ASSERT(found.euler == eulerOneByOne(dims, labels, label));
            RC_ASSERT(found.tunnels() >= 0); // so parts and cavities fit the number
        }
    });
}

} // namespace
} // namespace vs::segment

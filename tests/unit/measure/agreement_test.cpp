// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/agreement.h"

#include "masks.h"
#include "property.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vs::segment {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<std::uint8_t> boxMask(const volume::GridGeometry& grid, Box3 box) {
    return labelsWhere(grid, [&](glm::dvec3 p) {
        const glm::ivec3 voxel(glm::round(glm::dvec3(grid.voxelFromWorld() * glm::dvec4(p, 1))));
        return glm::all(glm::greaterThanEqual(voxel, box.lo)) && glm::all(glm::lessThan(voxel, box.hi));
    });
}

TEST(Agreement, OfASetWithItself) {
    const auto grid = centredGrid(40, {1, 1, 3});
    const auto ball = labelsWhere(grid, [](glm::dvec3 p) { return isInEllipsoid(p, glm::dvec3(15)); });
    const auto same = compare(grid, ball, ball);
    EXPECT_EQ(same.dice, 1);
    EXPECT_EQ(same.jaccard, 1);
    EXPECT_EQ(same.hausdorff95Mm, 0);
    EXPECT_EQ(same.meanSurfaceMm, 0);
    EXPECT_EQ(same.volumeDifferenceMl, 0);
    EXPECT_EQ(same.volumeDifferencePercent, 0);
}

TEST(Agreement, OfEmptySetsIsDefined) {
    const auto grid = volume::makeGeometry({10, 10, 10});
    const std::vector<std::uint8_t> empty(1000, 0);
    const auto some = boxMask(grid, {{2, 2, 2}, {4, 4, 4}});
    const auto none = compare(grid, empty, empty);
    EXPECT_EQ(none.dice, 1);
    EXPECT_EQ(none.jaccard, 1);
    EXPECT_EQ(none.hausdorff95Mm, 0);
    EXPECT_EQ(none.volumeDifferencePercent, 0);
    const auto missed = compare(grid, empty, some);
    EXPECT_EQ(missed.dice, 0);
    EXPECT_EQ(missed.jaccard, 0);
    EXPECT_EQ(missed.hausdorff95Mm, kInfinite);
    EXPECT_EQ(missed.meanSurfaceMm, kInfinite);
    EXPECT_DOUBLE_EQ(missed.volumeDifferenceMl, -0.008);
    EXPECT_EQ(missed.volumeDifferencePercent, -100);
    const auto invented = compare(grid, some, empty);
    EXPECT_EQ(invented.dice, 0);
    EXPECT_EQ(invented.volumeDifferencePercent, kInfinite);
}

// Boxes shifted along z: what they share and how far their borders lie apart can be counted.
TEST(Agreement, OfShiftedBoxes) {
    const auto grid = volume::makeGeometry({40, 40, 40}, {1, 1.5, 2});
    const auto a = boxMask(grid, {{5, 5, 5}, {25, 25, 25}});
    const auto b = boxMask(grid, {{5, 5, 9}, {25, 25, 29}});
    const auto result = compare(grid, a, b);
    EXPECT_DOUBLE_EQ(result.dice, 16.0 / 20);
    EXPECT_DOUBLE_EQ(result.jaccard, 16.0 / 24);
    EXPECT_EQ(result.volumeDifferenceMl, 0);
    // The lower face, 400 of 20^3 - 18^3 = 2168 border voxels, lies 4 slices or 8 mm from the other's border;
    // that is more than 5 % of them.
    EXPECT_NEAR(result.hausdorff95Mm, 8, 1e-5);
    EXPECT_EQ(result.hausdorff95Mm, compare(grid, b, a).hausdorff95Mm);
    EXPECT_EQ(result.meanSurfaceMm, compare(grid, b, a).meanSurfaceMm);
    const auto larger = compare(grid, boxMask(grid, {{5, 5, 5}, {25, 25, 30}}), a);
    EXPECT_DOUBLE_EQ(larger.volumeDifferencePercent, 25);
    EXPECT_DOUBLE_EQ(larger.volumeDifferenceMl, 20 * 20 * 5 * 3 / 1000.0);
}

// The overlap of two equal balls is a lens; concentric ones have their borders a constant distance apart.
TEST(Agreement, OfBalls) {
    const double r = 18;
    const double d = 6;
    const auto grid = centredGrid(60, {1, 1, 1.5});
    const auto ballAt = [&](double x, double radius) {
        return labelsWhere(
            grid, [&](glm::dvec3 p) { return isInEllipsoid(p - glm::dvec3(x, 0, 0), glm::dvec3(radius)); });
    };
    const double lens = (4 * r + d) * (2 * r - d) * (2 * r - d) / (16 * r * r * r); // part of the ball
    const auto shifted = compare(grid, ballAt(0, r), ballAt(d, r));
    EXPECT_NEAR(shifted.dice, lens, 0.005); // voxels are in or out as a whole
    EXPECT_NEAR(shifted.jaccard, lens / (2 - lens), 0.008);
    // The distance to the other sphere is close to d |cos| of the polar angle, up to d, spread evenly: its
    // mean is d / 2 and 95 % stay below 0.95 d. Border voxels lie up to half a diagonal inside.
    EXPECT_NEAR(shifted.hausdorff95Mm, 0.95 * d, 0.6);
    EXPECT_NEAR(shifted.meanSurfaceMm, d / 2, 0.4);
    const auto concentric = compare(grid, ballAt(0, r + 3), ballAt(0, r));
    EXPECT_NEAR(concentric.hausdorff95Mm, 3, 0.6);
    EXPECT_NEAR(concentric.meanSurfaceMm, 3, 0.3);
    EXPECT_NEAR(concentric.volumeDifferencePercent, 100 * (std::pow((r + 3) / r, 3) - 1), 1);
}

// The places of the voxels of a mask that have a neighbour across a face outside it, in mm.
std::vector<glm::dvec3> borderOf(const volume::GridGeometry& grid, const std::vector<std::uint8_t>& mask) {
    const auto inside = [&](glm::ivec3 v) {
        return glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, grid.dims)) &&
               mask[std::size_t((v.z * grid.dims.y + v.y) * grid.dims.x + v.x)] != 0;
    };
    std::vector<glm::dvec3> places;
    for (int i = 0; i < int(mask.size()); ++i) {
        const glm::ivec3 v(i % grid.dims.x, i / grid.dims.x % grid.dims.y, i / grid.dims.x / grid.dims.y);
        if (inside(v) && !(inside(v + glm::ivec3(1, 0, 0)) && inside(v - glm::ivec3(1, 0, 0)) &&
                           inside(v + glm::ivec3(0, 1, 0)) && inside(v - glm::ivec3(0, 1, 0)) &&
                           inside(v + glm::ivec3(0, 0, 1)) && inside(v - glm::ivec3(0, 0, 1)))) {
            places.push_back(glm::dvec3(v) * grid.spacing());
        }
    }
    return places;
}

// From each place to the nearest of the others, sorted.
std::vector<double> nearest(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
    std::vector<double> result;
    for (const glm::dvec3 p : from) {
        double least = kInfinite;
        for (const glm::dvec3 q : to) {
            least = std::min(least, glm::distance(p, q));
        }
        result.push_back(least);
    }
    std::sort(result.begin(), result.end());
    return result;
}

// A ball with a ragged surface that reaches over the grid's border: voxels near the surface are in it or not,
// as drawn.
std::vector<std::uint8_t> raggedBall(const volume::GridGeometry& grid, double radius) {
    const auto bites = *rc::gen::container<std::vector<int>>(grid.voxelCount(), test::below(40));
    std::size_t next = 0;
    return labelsWhere(grid, [&](glm::dvec3 p) {
        return glm::length(p - glm::dvec3(3, 4, 6)) + 0.1 * bites[next++] < radius;
    });
}

// Distances by looking at every pair of border voxels.
TEST(Agreement, DistancesAreExact) {
    const auto grid = volume::makeGeometry({14, 12, 9}, {0.8, 1, 2.5});
    test::checkProperty(3, [&grid] {
        const auto a = raggedBall(grid, *test::between(7, 9));
        const auto b = raggedBall(grid, *test::between(9, 12));
        const auto there = nearest(borderOf(grid, a), borderOf(grid, b));
        const auto back = nearest(borderOf(grid, b), borderOf(grid, a));
        const auto percentile = [](const std::vector<double>& sorted) {
            return sorted[std::size_t(std::ceil(0.95 * double(sorted.size()))) - 1];
        };
        double sum = 0;
        for (const auto* distances : {&there, &back}) {
            for (const double distance : *distances) {
                sum += distance;
            }
        }
        const auto result = compare(grid, a, b);
        // ITK's distances are floats.
        RC_ASSERT(std::abs(result.hausdorff95Mm - std::max(percentile(there), percentile(back))) < 1e-5);
        RC_ASSERT(std::abs(result.meanSurfaceMm - sum / double(there.size() + back.size())) < 1e-5);
    });
}

} // namespace
} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#include "phantom/phantom.h"
#include "volume/grid/geometry.h"

#include <gtest/gtest.h>

#include <numeric>

namespace vs::volume {
namespace {

TEST(Geometry, OrientationCodesNameTheDirections) {
    auto grid = makeGeometry({4, 5, 6}, {1, 2, 3});
    EXPECT_EQ(grid.orientationCode(), "LPS");
    grid.worldFromVoxel[0] *= -1.0;
    grid.worldFromVoxel[1] *= -1.0;
    EXPECT_EQ(grid.orientationCode(), "RAS");
    std::swap(grid.worldFromVoxel[1], grid.worldFromVoxel[2]);
    EXPECT_EQ(grid.orientationCode(), "RSA");
}

TEST(Geometry, MeasuresOfABox) {
    const auto grid = makeGeometry({10, 20, 20}, {2, 1, 1});
    EXPECT_EQ(grid.stepMm(), 1);
    EXPECT_EQ(grid.voxelMm3(), 2);
    EXPECT_NEAR(grid.diagonalMm(), std::sqrt(3.0) * 20, 1e-9);
    EXPECT_EQ(grid.centreWorld(), glm::dvec3(9, 9.5, 9.5));
    const auto there = grid.worldFromVoxel * glm::dvec4(1, 2, 3, 1);
    EXPECT_EQ(grid.voxelFromWorld() * there, glm::dvec4(1, 2, 3, 1));
}

TEST(Phantom, BallHasItsMeanOnTheSphere) {
    const auto ball = phantom::makeBall({41, 41, 41}, glm::dvec3(20), 12);
    EXPECT_EQ(ball.at({20, 20, 20}), 200);
    EXPECT_EQ(ball.at({0, 0, 0}), 0);
    EXPECT_EQ(ball.at({32, 20, 20}), 100);
    EXPECT_EQ(ball.range, (Range{0, 200}));
    const auto counts = histogram(ball, 16);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)), ball.geometry.voxelCount());
}

TEST(Volume, ChecksumTellsValuesAndSizesApart) {
    const auto a = phantom::makeBall({8, 8, 8}, glm::dvec3(4), 2);
    auto b = a;
    EXPECT_EQ(checksum(a), checksum(b));
    b.bytes[5] = std::byte(1);
    EXPECT_NE(checksum(a), checksum(b));
    b = a;
    b.geometry.dims = {16, 4, 8};
    EXPECT_NE(checksum(a), checksum(b));
}

} // namespace
} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
#include "phantom/phantom.h"
#include "property.h"
#include "volume/grid/geometry.h"
#include "volume/grid/histogram.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

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

// All 48 of them.
std::vector<std::string> orientationCodes() {
    std::vector<std::string> codes;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            std::string code;
            for (int i = 0; i < 3; ++i) {
                code += std::string_view("LRPASI")[std::size_t(2 * order[std::size_t(i)] + (signs >> i & 1))];
            }
            codes.push_back(code);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return codes;
}

GridGeometry someGrid() {
    auto grid = makeGeometry({*test::below(40) + 1, *test::below(40) + 1, *test::below(40) + 1},
                             {*test::between(0.01, 9), *test::between(0.01, 9), *test::between(0.01, 9)});
    const glm::dvec3 axis(*test::between(-1, 1), *test::between(-1, 1), 1);
    grid.worldFromVoxel = glm::rotate(glm::dmat4(1), *test::between(-0.6, 0.6), axis) * grid.worldFromVoxel;
    grid.worldFromVoxel[3] = glm::dvec4(*test::between(-300, 300), *test::between(-300, 300), 17, 1);
    return grid;
}

TEST(Geometry, GridsAreReorientedAboutTheirCentre) {
    const auto codes = orientationCodes();
    ASSERT_EQ(codes.size(), 48U);
    test::checkProperty(200, [&] {
        const GridGeometry grid = someGrid();
        const std::string& code = codes[std::size_t(*test::below(48))];
        const GridGeometry other = reoriented(grid, code);
        RC_ASSERT(other.orientationCode() == code);
        RC_ASSERT(glm::distance(other.centreWorld(), grid.centreWorld()) < 1e-9);
        RC_ASSERT(glm::distance(other.spacing(), grid.spacing()) < 1e-9);
        RC_ASSERT(std::abs(other.voxelMm3() / grid.voxelMm3() - 1) < 1e-9);
        // Each of its axes is one of the grid's, there or back: as oblique as that is.
        for (int i = 0; i < 3; ++i) {
            double best = 0;
            for (int j = 0; j < 3; ++j) {
                best = std::max(best, std::abs(glm::dot(glm::normalize(glm::dvec3(other.worldFromVoxel[i])),
                                                        glm::normalize(glm::dvec3(grid.worldFromVoxel[j])))));
            }
            RC_ASSERT(best > 1 - 1e-12);
        }
        RC_ASSERT(areMirrored(grid, other) == areMirrored(other, grid));
        RC_ASSERT(reoriented(grid, grid.orientationCode()) == grid);
    });
}

TEST(Geometry, HalfOfAllOrientationsAreMirrorImages) {
    const auto grid = makeGeometry({4, 5, 6});
    const auto codes = orientationCodes();
    EXPECT_EQ(std::count_if(codes.begin(), codes.end(),
                            [&](const auto& code) { return areMirrored(grid, reoriented(grid, code)); }),
              24);
    EXPECT_TRUE(areMirrored(grid, reoriented(grid, "RPS")));
    EXPECT_FALSE(areMirrored(grid, reoriented(grid, "RAS")));
}

TEST(Geometry, GridsAreRespacedAboutTheirCentre) {
    test::checkProperty(200, [] {
        const GridGeometry grid = someGrid();
        const glm::dvec3 spacing(*test::between(0.001, 1000), *test::between(0.001, 3), 2);
        const GridGeometry other = respaced(grid, spacing);
        RC_ASSERT(glm::length(other.spacing() / spacing - 1.0) < 1e-9);
        RC_ASSERT(glm::distance(other.centreWorld(), grid.centreWorld()) < 1e-6);
        RC_ASSERT(other.orientationCode() == grid.orientationCode());
        RC_ASSERT(respaced(grid, grid.spacing()) == grid);
    });
}

TEST(Geometry, OrientationCodesAreTold) {
    for (const std::string& code : orientationCodes()) {
        EXPECT_TRUE(isOrientationCode(code)) << code;
    }
    for (const char* code : {"", "L", "LP", "LPSL", "LRP", "LPP", "lps", "LPX", "ISA "}) {
        EXPECT_FALSE(isOrientationCode(code)) << code;
    }
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

// SPDX-License-Identifier: Apache-2.0
// Surfaces of sets that are not in memory as a whole.
#include "mesh/contour.h"
#include "mesh/segment_surface.h"

#include "segment/edits/label_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

namespace vs::mesh {
namespace {

using Point = std::array<float, 3>;
using Triangle = std::array<Point, 3>;

// The triangles by where their corners are, whatever the order they are listed in.
std::vector<Triangle> trianglesOf(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (const glm::uvec3& t : mesh.triangles) {
        Triangle triangle;
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 point = mesh.points[t[corner]];
            triangle[std::size_t(corner)] = {point.x, point.y, point.z};
        }
        // Turned so that the least corner comes first; which way round it goes stays.
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

void expectSame(const Mesh& whole, const Mesh& pieces) {
    EXPECT_EQ(pieces.points.size(), whole.points.size()); // none of them twice
    EXPECT_EQ(trianglesOf(pieces), trianglesOf(whole));
    const Topology a = topologyOf(whole);
    const Topology b = topologyOf(pieces);
    EXPECT_EQ(b.openEdges, 0U);
    EXPECT_EQ(std::tie(b.crowdedEdges, b.eulerNumber), std::tie(a.crowdedEdges, a.eulerNumber));
}

// Any set, anywhere in the grid: noise has every case of marching cubes.
TEST(Pieces, AreTheWhole) {
    std::mt19937 random(23);
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    for (int round = 0; round < 60; ++round) {
        auto grid = volume::makeGeometry(glm::ivec3(1 + below(20), 1 + below(20), 1 + below(20)),
                                         glm::dvec3(0.5, 1.0, 2.5));
        grid.worldFromVoxel[0] *= below(2) == 0 ? 1.0 : -1.0;
        const int share = 1 + below(9);
        segment::VoxelSet set = segment::emptySet(grid.box());
        for (std::uint8_t& inside : set.inside) {
            inside = below(10) < share ? 1 : 0;
        }
        const Crossing crossing = [](glm::ivec3 inside, glm::ivec3 outside) {
            return 0.1 + 0.01 * ((inside.x + 3 * inside.y + 7 * outside.z) % 80);
        };
        const int side = 2 + below(12);
        SCOPED_TRACE(testing::Message() << "round " << round << ", pieces of " << side);
        const Mesh pieces = contour(
            grid.box(), grid,
            [&](const Box3& box) {
                Piece piece{set.within(box), crossing};
                return piece.set.count() == 0 ? Piece{} : piece; // as of what is known to have nothing
            },
            side);
        expectSame(contour(set, grid, crossing), pieces);
    }
}

// Through the memberships of segments, that reach beyond a piece.
TEST(Pieces, OfSegments) {
    const auto grid = volume::makeGeometry({150, 70, 66}, glm::dvec3(1, 1, 1.5));
    std::vector<std::uint8_t> labels(grid.voxelCount());
    std::mt19937 random(5);
    forEachVoxel(grid.box(), [&](glm::ivec3 v, std::size_t i) {
        const bool isBall = glm::length(glm::dvec3(v) - glm::dvec3(64, 35, 30)) < 25;
        const bool isTube = v.y > 60 && v.z > 60; // reaches the border of the grid, and past pieces
        labels[i] = isBall ? 1 : isTube ? 2 : random() % 200 == 0 ? 1 : 0;
    });
    const auto at = [&](glm::ivec3 v) {
        return labels[(std::size_t(v.z) * std::size_t(grid.dims.y) + std::size_t(v.y)) *
                          std::size_t(grid.dims.x) +
                      std::size_t(v.x)];
    };
    std::size_t most = 0; // voxels asked for at once
    const LabelsByBox byBox{[&](const Box3& box) {
                                std::vector<std::uint8_t> own;
                                forEachVoxel(box, [&](glm::ivec3 v, std::size_t) { own.push_back(at(v)); });
                                most = std::max(most, own.size());
                                return own;
                            },
                            [&](const Box3& box) {
                                bool isEmpty = true;
                                forEachVoxel(
                                    box, [&](glm::ivec3 v, std::size_t) { isEmpty = isEmpty && at(v) == 0; });
                                return isEmpty;
                            }};
    const auto boxes = segment::labelBoxes(labels, grid.dims);
    for (const std::uint8_t label : {1, 2, 3}) {
        SCOPED_TRACE(int(label));
        expectSame(segmentSurface(labels, grid, label, boxes[label]), segmentSurface(byBox, grid, label));
    }
    EXPECT_LE(most, std::size_t(71 * 71 * 71));
}

TEST(Pieces, CanBeGivenUp) {
    const auto grid = volume::makeGeometry(glm::ivec3(20));
    const auto nothing = [](const Box3&) { return Piece{}; };
    std::vector<double> told;
    const Mesh mesh = contour(grid.box(), grid, nothing, 11, [&](double share) {
        told.push_back(share);
        return true;
    });
    EXPECT_TRUE(mesh.points.empty());
    EXPECT_EQ(told.size(), 27U); // 22 layers with those around, ten between those of a piece
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_ANY_THROW(contour(grid.box(), grid, nothing, 11, [](double share) { return share < 0.5; }));
}

} // namespace
} // namespace vs::mesh

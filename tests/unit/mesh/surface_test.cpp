// SPDX-License-Identifier: Apache-2.0
#include "mesh/visible_surface.h"

#include "shapes.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace vs::mesh {
namespace {

constexpr double kPi = glm::pi<double>();

void expectSolid(const Mesh& mesh, long eulerNumber) {
    const Topology topology = topologyOf(mesh);
    EXPECT_EQ(topology.openEdges, 0U);
    EXPECT_EQ(topology.crowdedEdges, 0U);
    EXPECT_EQ(topology.emptyTriangles, 0U);
    EXPECT_EQ(topology.eulerNumber, eulerNumber);
    EXPECT_GT(volumeMm3(mesh), 0); // not inside out
}

double worstRadiusError(const Mesh& mesh, double radius) {
    double worst = 0;
    for (const glm::vec3 point : mesh.points) {
        worst = std::max(worst, std::abs(double(glm::length(point)) - radius));
    }
    return worst;
}

Box3 boxOf(const Mesh& mesh, double perUnit) {
    glm::dvec3 lo(1e9);
    glm::dvec3 hi(-1e9);
    for (const glm::vec3 point : mesh.points) {
        lo = glm::min(lo, glm::dvec3(point));
        hi = glm::max(hi, glm::dvec3(point));
    }
    return {glm::ivec3(glm::round(lo * perUnit)), glm::ivec3(glm::round(hi * perUnit))};
}

template <typename T>
volume::Volume volumeWhere(const volume::GridGeometry& grid, volume::ScalarType type,
                           const std::function<double(glm::dvec3 voxel)>& value) {
    volume::Volume volume;
    volume.geometry = grid;
    volume.type = type;
    volume.bytes.resize(grid.voxelCount() * sizeof(T));
    for (std::size_t i = 0; i < grid.voxelCount(); ++i) {
        const int n = int(i);
        const T one =
            T(value({n % grid.dims.x, n / grid.dims.x % grid.dims.y, n / grid.dims.x / grid.dims.y}));
        std::memcpy(volume.bytes.data() + i * sizeof(T), &one, sizeof(T));
    }
    volume::computeRange(volume);
    return volume;
}

TEST(SegmentSurface, OfABall) {
    for (const double radius : {8.0, 20.0}) {
        const Mesh mesh = ball(radius);
        expectSolid(mesh, 2);
        // The set's own stairs are half a voxel; a Gaussian of one voxel leaves a third of that here and
        // there, and moves the level inward by 1 / radius.
        EXPECT_LT(worstRadiusError(mesh, radius), 0.35);
        EXPECT_NEAR(volumeMm3(mesh) / (4.0 / 3.0 * kPi * std::pow(radius, 3)), 1, radius < 10 ? 0.06 : 0.01);
        EXPECT_NEAR(areaMm2(mesh) / (4 * kPi * radius * radius), 1, radius < 10 ? 0.04 : 0.01);
    }
}

TEST(SegmentSurface, OfAnythingIsClosed) {
    // Noise has every case of marching cubes. Parts of it touch along edges, which are then passed twice each
    // way.
    std::mt19937 random(7);
    const auto grid = volume::makeGeometry(glm::ivec3(30));
    const Mesh mesh = surfaceWhere(grid, [&](glm::dvec3) { return int(random() % 2); });
    const Topology topology = topologyOf(mesh);
    EXPECT_EQ(topology.openEdges, 0U);
    EXPECT_EQ(topology.emptyTriangles, 0U);
    EXPECT_GT(mesh.triangles.size(), 10000U);
}

TEST(SegmentSurface, OfATorusHasAHole) {
    const Mesh mesh = torus(16, 6);
    expectSolid(mesh, 0);
    EXPECT_NEAR(volumeMm3(mesh) / (2 * kPi * kPi * 16 * 36), 1, 0.03);
}

TEST(SegmentSurface, LiesWhereTheVoxelsAre) {
    // An oblique, anisotropic grid that is left-handed too: the same ball in the world.
    const double radius = 12;
    auto grid = segment::centredGrid(40, {0.7, 1, 1.6});
    grid.worldFromVoxel = glm::translate(glm::dmat4(1), glm::dvec3(30, -50, 70)) *
                          glm::rotate(glm::dmat4(1), 0.6, glm::normalize(glm::dvec3(1, 2, -1))) *
                          glm::scale(glm::dmat4(1), glm::dvec3(1, -1, 1)) * grid.worldFromVoxel;
    ASSERT_LT(glm::determinant(glm::dmat3(grid.worldFromVoxel)), 0);
    const glm::dvec3 centre(30, -50, 70);
    Mesh mesh = surfaceWhere(grid, [&](glm::dvec3 p) { return glm::distance(p, centre) <= radius ? 1 : 0; });
    expectSolid(mesh, 2);
    for (glm::vec3& point : mesh.points) {
        point -= glm::vec3(centre);
    }
    EXPECT_LT(worstRadiusError(mesh, radius), 0.8); // half a slice
    EXPECT_NEAR(volumeMm3(mesh) / (4.0 / 3.0 * kPi * std::pow(radius, 3)), 1, 0.02);
}

TEST(SegmentSurface, IsCappedAtTheGridsBorder) {
    const auto grid = volume::makeGeometry({12, 10, 8}, {1, 1, 2});
    const Mesh mesh = surfaceWhere(grid, [](glm::dvec3) { return 1; });
    expectSolid(mesh, 2);
    // The faces of the outermost voxels, half a voxel from their centres.
    EXPECT_EQ(boxOf(mesh, 2), (Box3{{-1, -1, -2}, {23, 19, 30}}));
}

TEST(SegmentSurface, OfOneVoxelIsADot) {
    const auto grid = volume::makeGeometry(glm::ivec3(5));
    const Mesh mesh = surfaceWhere(grid, [](glm::dvec3 p) { return p == glm::dvec3(2) ? 1 : 0; });
    expectSolid(mesh, 2);
    EXPECT_GT(volumeMm3(mesh), 0.1);
}

TEST(SegmentSurface, OfNothingIsEmpty) {
    const auto grid = volume::makeGeometry(glm::ivec3(5));
    EXPECT_TRUE(surfaceWhere(grid, [](glm::dvec3) { return 0; }).triangles.empty());
}

TEST(SegmentSurface, OfNeighboursMeets) {
    // Two halves of a ball: each closed, together as large as the ball, and the wall between them flat.
    const auto grid = segment::centredGrid(40, glm::dvec3(1));
    const auto half = [](glm::dvec3 p) { return glm::length(p) > 15 ? 0 : p.x < 0 ? 1 : 2; };
    const Mesh left = surfaceWhere(grid, half, 1);
    const Mesh right = surfaceWhere(grid, half, 2);
    expectSolid(left, 2);
    expectSolid(right, 2);
    EXPECT_NEAR((volumeMm3(left) + volumeMm3(right)) / (4.0 / 3.0 * kPi * std::pow(15, 3)), 1, 0.03);
    for (const glm::vec3 point : left.points) {
        if (std::hypot(point.y, point.z) < 12) {
            EXPECT_LT(point.x, 0.5F); // no further than half a voxel beyond the wall
        }
    }
}

TEST(VisibleSurface, PassesWhereValuesCrossTheRange) {
    // A ramp: the surface of values from 40 on lies exactly at x = 4, and is capped at the border.
    const auto grid = volume::makeGeometry(glm::ivec3(12));
    const auto volume =
        volumeWhere<std::int16_t>(grid, volume::ScalarType::Int16, [](glm::dvec3 v) { return 10 * v.x; });
    const Mesh mesh = visibleSurface({&volume, {43, 1e9}});
    expectSolid(mesh, 2);
    EXPECT_EQ(boxOf(mesh, 10), (Box3{{43, -5, -5}, {115, 115, 115}}));
    // Values that are an end of the range: the surface passes beside the voxels, by a hundredth.
    const Mesh slab = visibleSurface({&volume, {40, 80}});
    expectSolid(slab, 2);
    EXPECT_EQ(boxOf(slab, 100), (Box3{{399, -50, -50}, {801, 1150, 1150}}));
}

TEST(VisibleSurface, IsCappedWhereItIsCut) {
    // The sculpture crosses 0.5 at z = 5.25; close to the surface of the data too, where both bend.
    const auto grid = volume::makeGeometry(glm::ivec3(16));
    const auto volume = volumeWhere<float>(grid, volume::ScalarType::Float32, [](glm::dvec3 v) {
        return 100 - 10 * glm::distance(v, glm::dvec3(7.5));
    });
    VisibleVolume visible{&volume, {50, 1e9}};
    for (std::size_t i = 0; i < grid.voxelCount(); ++i) {
        const std::size_t slice = i / 256;
        const auto z = double(slice);
        visible.sculpture.push_back(packed(float(glm::clamp(0.5 + 0.4 * (z - 5.25), 0.0, 1.0))));
    }
    const Mesh rest = visibleSurface(visible);
    expectSolid(rest, 2);
    EXPECT_EQ(boxOf(rest, 100).hi.z, 525);
    // Points are on the ball or on the cut, exactly.
    for (const glm::vec3 p : rest.points) {
        const double fromBall = std::abs(double(glm::distance(p, glm::vec3(7.5F))) - 5);
        EXPECT_LT(std::min(fromBall, std::abs(p.z - 5.25)), 0.05); // trilinear: chords of the ball
    }
    visible.view = field::SculptureView::Probe;
    const Mesh cut = visibleSurface(visible);
    expectSolid(cut, 2);
    visible.view = field::SculptureView::Whole;
    const Mesh whole = visibleSurface(visible);
    EXPECT_NEAR((volumeMm3(rest) + volumeMm3(cut)) / volumeMm3(whole), 1, 0.02); // chamfers at the cut's edge
}

TEST(VisibleSurface, LeavesOutWhatIsNoNumber) {
    const auto grid = volume::makeGeometry(glm::ivec3(8));
    const auto volume = volumeWhere<float>(grid, volume::ScalarType::Float32, [](glm::dvec3 v) {
        return v == glm::dvec3(4) ? std::nan("") : 1.0;
    });
    const Mesh mesh = visibleSurface({&volume, {0.5, 2}});
    expectSolid(mesh, 4); // a box, and a hole in it
}

} // namespace
} // namespace vs::mesh

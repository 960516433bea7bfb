// SPDX-License-Identifier: Apache-2.0
#include "mesh/refine.h"

#include "base/progress.h"
#include "mesh/close_holes.h"

#include "shapes.h"

#include <gtest/gtest.h>

#include <random>

namespace vs::mesh {
namespace {

void expectClosed(const Mesh& mesh, long eulerNumber) {
    const Topology topology = topologyOf(mesh);
    EXPECT_EQ(topology.openEdges, 0U);
    EXPECT_EQ(topology.emptyTriangles, 0U);
    EXPECT_EQ(topology.eulerNumber, eulerNumber);
}

// How far normals of a ball's surface lean away from its radius: what the eye sees of steps.
double roughness(const Mesh& mesh) {
    const auto normals = normalsOf(mesh);
    double sum = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        sum += std::acos(glm::clamp(double(glm::dot(normals[i], glm::normalize(mesh.points[i]))), -1.0, 1.0));
    }
    return sum / double(normals.size());
}

TEST(Refined, DecimationKeepsShape) {
    for (const Mesh& mesh : {ball(20), torus(16, 6)}) {
        const long euler = topologyOf(mesh).eulerNumber;
        const double before = volumeMm3(mesh);
        for (const double share : {0.5, 0.1}) {
            const Mesh few = refined(mesh, {0, share});
            expectClosed(few, euler);
            EXPECT_NEAR(double(few.triangles.size()) / double(mesh.triangles.size()), share, 0.02);
            EXPECT_NEAR(volumeMm3(few) / before, 1, 0.005);
        }
    }
}

TEST(Refined, LeavesNoHolesInRaggedSurfaces) {
    // Noise, smoothed a little: thousands of thin bridges that fold when they are simplified.
    std::mt19937 random(3);
    const auto grid = volume::makeGeometry(glm::ivec3(40));
    const Mesh ragged = surfaceWhere(grid, [&](glm::dvec3) { return int(random() % 4 == 0); });
    for (const double share : {0.7, 0.3, 0.05}) {
        const Topology topology = topologyOf(refined(ragged, {0, share}));
        EXPECT_EQ(topology.openEdges, 0U);
    }
}

TEST(CloseHoles, FillsWhatIsMissing) {
    Mesh mesh = ball(6);
    const double whole = volumeMm3(mesh);
    mesh.triangles.erase(mesh.triangles.begin() + 40, mesh.triangles.begin() + 43);
    mesh.triangles.erase(mesh.triangles.begin());
    ASSERT_FALSE(topologyOf(mesh).isClosed());
    closeHoles(mesh);
    EXPECT_TRUE(topologyOf(mesh).isClosed());
    EXPECT_EQ(topologyOf(mesh).eulerNumber, 2);
    EXPECT_NEAR(volumeMm3(mesh), whole, 0.01 * whole);
    // A flap of two triangles on each other is nothing.
    const auto count = mesh.triangles.size();
    mesh.triangles.emplace_back(0, 1, 2);
    mesh.triangles.emplace_back(1, 0, 2);
    closeHoles(mesh);
    EXPECT_EQ(mesh.triangles.size(), count);
}

TEST(Refined, KeepsToACount) {
    const Mesh mesh = ball(20);
    EXPECT_LE(refined(mesh, {0, 1, 1000}).triangles.size(), 1000U);
    EXPECT_GE(refined(mesh, {0, 1, 1000}).triangles.size(), 950U);
    EXPECT_EQ(refined(mesh, {0, 1, 1U << 30}).triangles.size(), mesh.triangles.size());
}

TEST(Refined, SmoothingTakesStepsAndKeepsVolume) {
    const Mesh mesh = ball(15, {1, 1, 3});
    const Mesh smooth = refined(mesh, {20});
    expectClosed(smooth, 2);
    EXPECT_EQ(smooth.triangles, mesh.triangles);
    EXPECT_LT(roughness(smooth), 0.6 * roughness(mesh));
    EXPECT_NEAR(volumeMm3(smooth) / volumeMm3(mesh), 1, 0.01);
}

TEST(Refined, ChangesNothingUnasked) {
    Mesh mesh = ball(6);
    mesh.name = "ball";
    mesh.colour = {1, 0, 0};
    const Mesh same = refined(mesh, {});
    EXPECT_EQ(same.points, mesh.points);
    const Mesh few = refined(mesh, {5, 0.5});
    EXPECT_EQ(few.name, "ball");
    EXPECT_EQ(few.colour, mesh.colour);
}

TEST(Refined, CanBeGivenUp) {
    const auto no = [](double) { return false; };
    EXPECT_THROW(refined(ball(20), {50}, no), GivenUp);
    EXPECT_THROW(refined(ball(20), {0, 0.1}, no), GivenUp);
}

} // namespace
} // namespace vs::mesh

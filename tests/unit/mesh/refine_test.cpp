// SPDX-License-Identifier: Apache-2.0
#include "mesh/refine.h"

#include "shapes.h"

#include <gtest/gtest.h>

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

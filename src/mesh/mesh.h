// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace vs::mesh {

// A surface of triangles in the patient: points in world space (LPS millimetres), the corners of a triangle
// counter-clockwise as seen from outside.
struct Mesh {
    std::vector<glm::vec3> points;
    std::vector<glm::uvec3> triangles;
    // The mesh's name, for formats that hold one.
    std::string name;
    glm::dvec3 colour{0.8}; // sRGB, 0 to 1
    double opacity = 1;
    std::vector<glm::vec3> colours; // sRGB, of each point; empty: all have the mesh's

    [[nodiscard]] glm::dvec3 colourOf(std::size_t point) const {
        return colours.empty() ? colour : glm::dvec3(colours[point]);
    }
};

// What long work reports its progress to, from 0 to 1; it returns false to have the work given up. May be
// empty. Called on the thread that works.
using Progress = std::function<bool(double share)>;

// Tells `progress`; throws vs::GivenUp if it says so.
void report(const Progress& progress, double share);

// The progress of a part of longer work, which takes the share [from, to] of all of it.
Progress partOf(const Progress& progress, double from, double to);

double areaMm2(const Mesh& mesh);
// The volume that a mesh encloses; below zero when it is inside out.
double volumeMm3(const Mesh& mesh);

// How the triangles hang together. A surface is closed when each edge is passed as often one way as the
// other.
struct Topology {
    std::size_t openEdges = 0;    // passed more often one way than the other
    std::size_t crowdedEdges = 0; // between more than two triangles
    std::size_t emptyTriangles = 0;
    long eulerNumber = 0; // 2 for each ball, 0 for each torus; points without triangles do not count

    [[nodiscard]] bool isClosed() const { return openEdges == 0; }
};
Topology topologyOf(const Mesh& mesh);

// Unit normals at the points, the mean of the triangles around each by their areas.
std::vector<glm::vec3> normalsOf(const Mesh& mesh);

} // namespace vs::mesh

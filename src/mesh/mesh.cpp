// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.h"

#include "base/progress.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace vs::mesh {

namespace {

// Twice the triangle's area, along its normal.
glm::dvec3 crossOf(const Mesh& mesh, glm::uvec3 t) {
    const glm::dvec3 a(mesh.points[t.x]);
    return glm::cross(glm::dvec3(mesh.points[t.y]) - a, glm::dvec3(mesh.points[t.z]) - a);
}

// All edges as (smaller point, larger point, which way), sorted.
std::vector<std::pair<std::uint64_t, int>> edgesOf(const Mesh& mesh) {
    std::vector<std::pair<std::uint64_t, int>> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3 t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t a = t[i];
            const std::uint64_t b = t[(i + 1) % 3];
            edges.emplace_back(std::min(a, b) << 32 | std::max(a, b), a < b ? 1 : -1);
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

} // namespace

void report(const Progress& progress, double share) {
    if (progress && !progress(share)) {
        throw GivenUp("the export was given up");
    }
}

Progress partOf(const Progress& progress, double from, double to) {
    if (!progress) {
        return {};
    }
    return [progress, from, to](double share) { return progress(from + share * (to - from)); };
}

double areaMm2(const Mesh& mesh) {
    double twice = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        twice += glm::length(crossOf(mesh, t));
    }
    return twice / 2;
}

double volumeMm3(const Mesh& mesh) {
    if (mesh.points.empty()) {
        return 0;
    }
    const glm::dvec3 origin(mesh.points.front()); // near, so that no digits are lost
    double sixfold = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        sixfold += glm::dot(glm::dvec3(mesh.points[t.x]) - origin, crossOf(mesh, t));
    }
    return sixfold / 6;
}

Topology topologyOf(const Mesh& mesh) {
    Topology found;
    long edgeCount = 0;
    const auto edges = edgesOf(mesh);
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next =
            std::find_if(edge, edges.end(), [&](const auto& other) { return other.first != edge->first; });
        int balance = 0;
        std::for_each(edge, next, [&](const auto& one) { balance += one.second; });
        found.openEdges += balance != 0 ? 1 : 0;
        found.crowdedEdges += next - edge > 2 ? 1 : 0;
        ++edgeCount;
        edge = next;
    }
    std::vector<bool> isUsed(mesh.points.size());
    for (const glm::uvec3 t : mesh.triangles) {
        isUsed[t.x] = isUsed[t.y] = isUsed[t.z] = true;
        found.emptyTriangles += crossOf(mesh, t) == glm::dvec3(0) ? 1 : 0;
    }
    found.eulerNumber =
        std::count(isUsed.begin(), isUsed.end(), true) - edgeCount + long(mesh.triangles.size());
    return found;
}

std::vector<glm::vec3> normalsOf(const Mesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.points.size(), glm::dvec3(0));
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 cross = crossOf(mesh, t);
        sums[t.x] += cross;
        sums[t.y] += cross;
        sums[t.z] += cross;
    }
    std::vector<glm::vec3> normals(sums.size());
    std::transform(sums.begin(), sums.end(), normals.begin(), [](glm::dvec3 sum) {
        const double length = glm::length(sum);
        return length > 0 ? glm::vec3(sum / length) : glm::vec3(0, 0, 1);
    });
    return normals;
}

} // namespace vs::mesh

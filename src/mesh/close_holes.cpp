// SPDX-License-Identifier: Apache-2.0
#include "mesh/close_holes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace vs::mesh {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Edges that are missing for every one to be passed as often one way as the other: for each point, those to
// which an edge is wanted.
std::multimap<std::uint32_t, std::uint32_t> missingEdges(const Mesh& mesh) {
    std::vector<Edge> there;
    std::vector<Edge> back;
    there.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3 t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            there.emplace_back(t[i], t[(i + 1) % 3]);
        }
    }
    back.resize(there.size());
    std::transform(there.begin(), there.end(), back.begin(),
                   [](const Edge& edge) { return Edge(edge.second, edge.first); });
    std::sort(there.begin(), there.end());
    std::sort(back.begin(), back.end());
    std::vector<Edge> missing;
    std::set_difference(back.begin(), back.end(), there.begin(), there.end(), std::back_inserter(missing));
    return {missing.begin(), missing.end()};
}

void dropFacingPairs(Mesh& mesh) {
    // By corners in order of their numbers: how many more face one way than the other.
    const auto sorted = [](glm::uvec3 t) {
        std::array<std::uint32_t, 3> corners{t.x, t.y, t.z};
        std::sort(corners.begin(), corners.end());
        return corners;
    };
    const auto isEven = [](glm::uvec3 t) { return (t.x < t.y) == (t.y < t.z) ? t.x < t.z : t.z < t.x; };
    struct Placed {
        std::array<std::uint32_t, 3> corners;
        bool isEven;
        std::size_t triangle;
        auto operator<=>(const Placed&) const =
            default; // NOLINT(modernize-use-nullptr): clang-tidy 14 mistakes it
    };
    std::vector<Placed> placed;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        placed.push_back({sorted(mesh.triangles[i]), isEven(mesh.triangles[i]), i});
    }
    std::sort(placed.begin(), placed.end());
    std::vector<bool> goes(placed.size());
    for (std::size_t i = 0; i + 1 < placed.size(); ++i) {
        if (placed[i].corners == placed[i + 1].corners && placed[i].isEven != placed[i + 1].isEven) {
            goes[placed[i].triangle] = goes[placed[i + 1].triangle] = true;
            ++i;
        }
    }
    std::vector<glm::uvec3> left;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!goes[i]) {
            left.push_back(mesh.triangles[i]);
        }
    }
    mesh.triangles = std::move(left);
}

} // namespace

void closeHoles(Mesh& mesh) {
    auto missing = missingEdges(mesh);
    while (!missing.empty()) {
        // As many edges come to a point as leave it, so that each way leads back to where it began.
        const std::uint32_t first = missing.begin()->first;
        std::uint32_t at = first;
        do {
            const auto edge = missing.find(at);
            const std::uint32_t next = edge->second;
            missing.erase(edge);
            if (at != first && next != first) {
                mesh.triangles.emplace_back(first, at, next);
            }
            at = next;
        } while (at != first);
    }
    dropFacingPairs(mesh);
}

} // namespace vs::mesh

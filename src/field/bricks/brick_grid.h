// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "volume/grid/geometry.h"

#include <optional>
#include <tuple>

namespace vs::field {

// A brick of a scan in levels: `place` is its number in its level's BrickGrid.
struct BrickKey {
    int level = 0;
    int place = 0;
    bool operator==(const BrickKey&) const = default;
    bool operator<(const BrickKey& other) const {
        return std::tie(level, place) < std::tie(other.level, other.place);
    }
};

// How a level is cut into bricks, and how its voxel space lies in that of a scene. A brick is looked up
// between its own voxels and the first ones of the bricks behind it, so that it has texels of side + 1 voxels
// along each axis; what lies beyond the grid is what is at its border.
struct BrickGrid {
    glm::ivec3 dims{1};          // voxels of the level
    int side = 64;               // voxels of a brick along each axis
    glm::dvec3 perSceneVoxel{1}; // place in the level = place in the scene * this
    glm::dvec3 origin{0};        // + this
    double step = 1;             // its smallest spacing, in steps of the scene
    glm::dvec3 spacing{1};       // all three, likewise

    // Finer than the scene along some axis.
    [[nodiscard]] bool isFiner() const { return glm::any(glm::greaterThan(perSceneVoxel, glm::dvec3(1.01))); }
    [[nodiscard]] glm::ivec3 counts() const { return divideUp(dims, side); }
    [[nodiscard]] std::size_t count() const {
        const glm::ivec3 n = counts();
        return std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z);
    }
    [[nodiscard]] int placeOf(glm::ivec3 brick) const {
        const glm::ivec3 n = counts();
        return (brick.z * n.y + brick.y) * n.x + brick.x;
    }
    [[nodiscard]] glm::ivec3 brickAt(int place) const {
        const glm::ivec3 n = counts();
        return {place % n.x, place / n.x % n.y, place / n.x / n.y};
    }
    // The voxels that are a brick's own.
    [[nodiscard]] Box3 boxOf(glm::ivec3 brick) const {
        return intersect({brick * side, (brick + 1) * side}, {glm::ivec3(0), dims});
    }
    // Texels of a brick along each axis.
    [[nodiscard]] int texels() const { return side + 1; }
};

// The bricks of a level in the voxel space of a scene; nothing where its axes lie otherwise than the scene's.
std::optional<BrickGrid> brickGrid(const volume::GridGeometry& level, const volume::GridGeometry& scene,
                                   int side);

// Where the voxels of such a level lie when the scene's lie there.
volume::GridGeometry finerGeometry(const volume::GridGeometry& scene, const BrickGrid& grid);

} // namespace vs::field

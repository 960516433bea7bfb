// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vs::sculpt {

// A raster of surface points as the skirt needs it. Elements are numbered x fastest.
struct SkirtInput {
    glm::ivec2 size{0};
    std::function<bool(int, int)> isHit;
    std::function<glm::vec3(int, int)> place;             // of a hit, in steps
    std::function<bool(glm::ivec2, glm::ivec2)> isJoined; // two neighbours are on one piece
    glm::vec3 direction{0, 0, 1};                         // the tool's, unit
    glm::vec3 alongX{1, 0, 0}; // in steps, from one element to the next, across the direction
    glm::vec3 alongY{0, 1, 0};
    float gap = 1;            // steps; what lies farther behind than this is another piece
    bool coversOthers = true; // goes on in front of pieces behind too, else only where there is nothing
    int reach = 1;            // elements
};

// One element of the raster: which hit it continues (x, y; -1: none), and where, in steps.
struct SkirtElement {
    glm::ivec2 from{-1};
    glm::vec3 place{0};

    [[nodiscard]] bool exists() const { return from.x >= 0; }
};

// Where pieces of a surface would go on beyond their silhouettes: level with the nearest hit on the
// silhouette, up to `reach` elements from it, where there is nothing or only something behind. Empty when no
// piece ends within the raster.
std::vector<SkirtElement> surfaceSkirt(const SkirtInput& input);

} // namespace vs::sculpt

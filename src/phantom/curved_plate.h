// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <span>
#include <vector>

namespace vs::phantom {

// Signed distance to the area within a closed outline, negative inside.
double outlineDistance(glm::dvec2 p, std::span<const glm::dvec2> outline);

// An outline with its corners cut off twice, so that it looks round (Chaikin's subdivision).
std::vector<glm::dvec2> rounded(std::vector<glm::dvec2> outline);

// A flat bone: a plate of even thickness whose middle surface bends away from a plane. Lengths in mm.
class CurvedPlate {
public:
    // How the middle surface lies above the plane at (s, v): bend[0] + bend[1] s² + bend[2] s v + bend[3] v².
    struct Form {
        glm::dvec3 origin{0};
        glm::dvec3 along{1, 0, 0};  // the direction of s
        glm::dvec3 across{0, 0, 1}; // of v, made perpendicular to it
        glm::dvec4 bend{0};
        std::vector<glm::dvec2> outline; // (s, v)
        double thicknessMm = 6;
        double rimMm = 0; // by how much it is thicker along its outline
    };

    explicit CurvedPlate(Form form);

    // Signed distance, with the edges rounded.
    [[nodiscard]] double distance(glm::dvec3 p) const;

private:
    Form form_;
    glm::dvec3 normal_;
    double reachMm_; // from the origin to the farthest corner
};

} // namespace vs::phantom

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/tube_set.h"

#include <cstdint>
#include <functional>

namespace vs::phantom {

// A signed distance in mm.
using Distance = std::function<double(glm::dvec3)>;

// How a branch sets out.
struct Sprout {
    TubePoint from;
    glm::dvec3 direction{0};
    double lengthMm = 15;
    int divisions = 3; // how often it divides in two, one branch after the other
    std::uint64_t seed = 0;
};

// Grows a branch and all that divide from it into `tubes`. They creep along the surface where `surface` is 0,
// meandering, and become thinner as they divide; what is no thicker than 1.2 mm divides no more. Always the
// same for the same sprout.
void growBranches(TubeSet& tubes, const Distance& surface, const Sprout& sprout);

} // namespace vs::phantom

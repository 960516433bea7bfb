// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/head_shape.h"

namespace vs::phantom {

// Bones of the skull phantom: signed distances in mm, negative inside, in head coordinates (head_shape.h).
// Neither has room for teeth: those are painted over them.

// The outside of the vault and the base, smoother than that of the head phantom.
double vault(glm::dvec3 p, const HeadShape& shape);
// The skull without its inside, which is solid here: vault, base, and face with orbits and nose, down to the
// upper jaw's rim.
double cranium(glm::dvec3 p, const HeadShape& shape);
// The lower jaw.
double mandible(glm::dvec3 p);
// The upper five vertebrae of the neck.
double neckVertebrae(glm::dvec3 p);

// The orbits, which eyes and fat fill.
double orbits(glm::dvec3 p);
// What is full of air: nose, throat, and the canals of the ears.
double airWays(glm::dvec3 p);
// Rooms of air in the bones of forehead, cheeks and base, which do not reach their surface by themselves.
double sinuses(glm::dvec3 p);

} // namespace vs::phantom

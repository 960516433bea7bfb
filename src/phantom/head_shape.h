// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

namespace vs::phantom {

// The outer form of the made heads: signed distances in mm, negative inside, in head coordinates (origin in
// the middle of the head phantom's box, x to the left, y backwards, z up).
struct HeadShape {
    // Where skull and brain are built of ellipsoids: narrower in front than behind.
    glm::dvec3 skullPlace{0};
    double inner = 0; // to the room for brain and fluid
    double outer = 0; // to the vault's outside
    double skin = 0;  // to the skin of vault, face, jaw, neck and ears; deep in the brain only a bound
};

HeadShape headShape(glm::dvec3 p);

// Signed distance to the room for brain and fluid, of a `skullPlace`.
double skullInside(glm::dvec3 skullPlace);

// A place with both sides of the head alike.
inline glm::dvec3 mirrored(glm::dvec3 p) { return {p.x < 0 ? -p.x : p.x, p.y, p.z}; }

} // namespace vs::phantom

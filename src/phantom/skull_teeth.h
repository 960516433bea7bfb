// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

namespace vs::phantom {

// Teeth of the skull phantom, in head coordinates in mm (head_shape.h).

// The height at which the upper and the lower teeth would meet.
inline constexpr double kBiteZ = -88;

enum class Jaw { Upper, Lower };

// A place beside the curve on which the teeth of a jaw stand.
struct ArchPlace {
    double alongMm = 0;    // from the middle of the face, on either side
    double distanceMm = 0; // from the curve, seen from above; never negative
};
ArchPlace besideArch(Jaw jaw, glm::dvec3 p);

// Signed distances to the tooth that is closest to a place and to what it is made of.
struct Tooth {
    int number = 0;    // in its quadrant, from 1 (beside the middle) to 8; 0 if no tooth is near
    double crown = 99; // enamel with what it covers
    double root = 99;
    double dentine = 99; // within the crown and the root
    double pulp = 99;
};
// Eight teeth a quadrant, 1.5 mm from each other. Molars have two roots.
Tooth toothNear(glm::dvec3 p);

} // namespace vs::phantom

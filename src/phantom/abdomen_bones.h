// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

namespace vs::phantom {

// Bones of the abdomen phantom: signed distances in mm, negative inside. Body coordinates: origin in the
// grid's middle, x to the left, y backwards, z up.

// How far back the middle of the vertebral bodies is at a height.
double spineDepth(double z);

struct SpineDistances {
    double bone = 0;
    double disc = 0;  // bodies and discs together
    double canal = 0; // the room for the spinal cord
};
// The spine from the tenth thoracic vertebra to the fifth lumbar one, with arches and processes. Far from it
// distances are only bounds.
SpineDistances spine(glm::dvec3 p);

// Hip bones and sacrum. They do not touch each other: cartilage is between.
double pelvis(glm::dvec3 p);
// Both femora, whose heads lie in the sockets of the hip bones with a gap of 4 mm.
double femora(glm::dvec3 p);

} // namespace vs::phantom

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/tube_set.h"

namespace vs::phantom {

// Tubes of the abdomen phantom, in body coordinates in mm (abdomen_bones.h).

// The room for blood in the aorta, both iliac and both renal arteries, and the first of the femoral ones.
TubeSet abdominalArteries();
// The wires of a stent graft: rings of zigzags in the wall of the lower aorta and of both common iliac
// arteries.
TubeSet stentWires();
// The ribs from the seventh to the twelfth as far as they reach into the grid, two tubes each.
TubeSet lowerRibs();
// The colon's middle line from caecum to rectum with its radius between haustra, one tube.
TubeSet colonCourse();

} // namespace vs::phantom

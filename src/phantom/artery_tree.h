// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/tube_set.h"

namespace vs::phantom {

// The arteries that supply a brain, in head coordinates in mm (head_shape.h): drawn by hand as far as they
// have names, branching by a rule beyond, over the brain that fills the skull. No two sides are quite alike.
TubeSet arteryTree();

// Veins on the right: tube 0 leads from the carotid below the skull to the cheek, tube 1 from there to the
// temple.
TubeSet veinTree();

} // namespace vs::phantom

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

namespace vs::reference {

// The definition of tricubic sampling (doc/behaviour.md, "What is visible"): the uniform cubic B-spline with
// the stored values as its coefficients, 64 of them weighted one by one. Beyond the grid values are those at
// its border.
struct SplineSample {
    double value = 0;
    glm::dvec3 gradient{0}; // world, in the volume's unit per mm
};
SplineSample bsplineAt(const volume::Volume& volume, glm::dvec3 voxel);

} // namespace vs::reference

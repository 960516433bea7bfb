// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

namespace vs::reference {

// A volume's value between voxel centres: the eight around, weighted one by one; beyond the outermost centres
// as there.
double trilinearAt(const volume::Volume& volume, glm::dvec3 voxel);

// The gradient's magnitude there, per mm: those of the eight voxels around, central differences one voxel
// wide, weighted likewise. For grids along the world's axes.
double gradientBetween(const volume::Volume& volume, glm::dvec3 voxel);

} // namespace vs::reference

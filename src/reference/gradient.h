// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <vector>

namespace vs::reference {

// Gradient magnitude at every voxel's centre (doc/behaviour.md, "Spaces and units"): central differences over
// spacing along the patient's axes, in the volume's unit per mm; beyond the grid values are those at its
// border. Infinite where the voxel or one that the differences take is not finite.
std::vector<double> gradientMagnitudes(const volume::Volume& volume);

} // namespace vs::reference

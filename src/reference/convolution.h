// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <vector>

namespace vs::reference {

// A volume's values convolved with a Gaussian of so many steps, x fastest: three axes one after the other,
// weights from the integral of the Gaussian over each voxel, which end at three sigma. At the border the
// outermost values go on; values that are not finite count for nothing and stay.
std::vector<double> convolved(const volume::Volume& volume, double sigmaSteps);

} // namespace vs::reference

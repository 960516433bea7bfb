// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "growing_itk.h"

namespace vs {

// A plain scanline fill on one core: whole runs along x, from a stack (Smith 1979, "Tint fill", in three
// dimensions). It says which voxels, not when. Timed with the allocation of its labels (uint8).
PeerRun growByScanlines(const GrowingCase& task);

} // namespace vs

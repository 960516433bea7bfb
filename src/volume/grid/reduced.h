// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

namespace vs::volume {

// What a block of voxels becomes: their mean (of those that were measured, if any), for scans; or the value
// that most of them have, the smallest of those that are equally many, for label maps.
enum class Reducing { Mean, Commonest };

// A volume of which each block of `by` voxels (1 or more along each axis) has become one, in the middle of
// where they were, for devices that have no room for all of it. Blocks at the far sides may be of fewer.
Volume reduced(const Volume& volume, glm::ivec3 by, Reducing how);
// Its values alone, computed by the calling thread.
std::vector<std::byte> reducedValues(const Volume& volume, glm::ivec3 by, Reducing how);

} // namespace vs::volume

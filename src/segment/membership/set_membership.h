// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_set.h"

#include <cstdint>
#include <vector>

namespace vs::segment {

// How much of each voxel in a box belongs to a set, as Segmentation has it for one segment: from 0 to 255, at
// least 128 at the set's voxels, x fastest. Nothing where it is 0 throughout. `spacing`, in mm, is the set's
// grid's; voxels beyond that belong to nobody.
std::vector<std::uint8_t> membershipOf(const FineSet& set, const Box3& box, const glm::dvec3& spacing);

} // namespace vs::segment

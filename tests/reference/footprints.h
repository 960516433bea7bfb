// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <span>
#include <vector>

namespace vs::reference {

// Direct splatting with a cube footprint: each point (xyz voxel space, w energy) spreads its energy over a
// box of `halfWidthVoxels` either side. A voxel's weight along an axis is the part of the box that lies in
// its cell when the box is centred on a voxel, interpolated linearly for places between. Result: dims voxels,
// x fastest.
std::vector<float> radiateCube(std::span<const glm::vec4> points, glm::ivec3 dims,
                               glm::dvec3 halfWidthVoxels);

} // namespace vs::reference

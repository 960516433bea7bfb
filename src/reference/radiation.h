// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <span>
#include <vector>

namespace vs::reference {

// The definition of point radiation (doc/behaviour.md, "Point radiation"; thesis, section 3.4.1): each point
// (xyz voxel space, w energy) spreads its energy over the voxels around it, 2 * ceil(3 sigma) along each
// axis, with Gaussian weights of `sigmaVoxels` that sum to 1 for each point; contributions add. Result: dims
// voxels, x fastest.
std::vector<float> radiate(std::span<const glm::vec4> points, glm::ivec3 dims, glm::dvec3 sigmaVoxels);

} // namespace vs::reference

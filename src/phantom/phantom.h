// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <functional>

namespace vs::phantom {

// A volume made in memory from a function of voxel coordinates (not world), rounded to the type's values.
volume::Volume makePhantom(glm::ivec3 dims, volume::ScalarType type,
                           const std::function<double(glm::dvec3 voxel)>& value,
                           glm::dvec3 spacing = glm::dvec3(1.0));

// A solid ball whose intensity falls linearly from `inside` to `outside` across `edgeVoxels` around its
// border, so the mean of both lies exactly on the sphere.
volume::Volume makeBall(glm::ivec3 dims, glm::dvec3 centreVoxel, double radiusVoxels, double inside = 200,
                        double outside = 0, double edgeVoxels = 4,
                        volume::ScalarType type = volume::ScalarType::UInt8);

} // namespace vs::phantom

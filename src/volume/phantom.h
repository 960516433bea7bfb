// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/volume.h"

#include <functional>

namespace vs::volume {

// A volume made in memory from a function of voxel coordinates (not world), rounded to the type's values.
Volume makePhantom(glm::ivec3 dims, ScalarType type, const std::function<double(glm::dvec3 voxel)>& value,
                   glm::dvec3 spacing = glm::dvec3(1.0));

// A solid ball whose intensity falls linearly from `inside` to `outside` across `edgeVoxels` around its
// border, so the mean of both lies exactly on the sphere.
Volume makeBall(glm::ivec3 dims, glm::dvec3 centreVoxel, double radiusVoxels, double inside = 200,
                double outside = 0, double edgeVoxels = 4, ScalarType type = ScalarType::UInt8);

} // namespace vs::volume

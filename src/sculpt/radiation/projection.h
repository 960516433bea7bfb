// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/mask/mask.h"
#include "sculpt/path/path.h"

#include <span>
#include <vector>

namespace vs::sculpt {

// The swept volume by projection, the comparison of the thesis, section 3.6.4 (Winter and Chen 2002,
// "Image-swept volumes"): a voxel between two successive places of the mask is projected onto both along the
// direction in which the mask moves there, the mask is sampled bilinearly at both, and the values are
// interpolated linearly by the distances. Voxels between no two places are 0; of several pieces the largest
// value counts. `mask` and `path` in steps; result: `dims` voxels, x fastest, values from 0 to 1.
std::vector<float> projectSweep(const MaskRaster& mask, std::span<const PathPiece> path, glm::ivec3 dims,
                                const glm::dvec3& voxelFromSteps = glm::dvec3(1));

} // namespace vs::sculpt

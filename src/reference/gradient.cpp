// SPDX-License-Identifier: Apache-2.0
#include "reference/gradient.h"

#include <cmath>
#include <limits>

namespace vs::reference {

std::vector<double> gradientMagnitudes(const volume::Volume& volume) {
    const glm::ivec3 dims = volume.geometry.dims;
    const glm::dmat3 worldFromVoxelGradient = glm::transpose(glm::dmat3(volume.geometry.voxelFromWorld()));
    std::vector<double> out;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const glm::ivec3 p(x, y, z);
                glm::dvec3 difference(0);
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 offset(0);
                    offset[axis] = 1;
                    difference[axis] = 0.5 * (volume.at(glm::min(p + offset, dims - 1)) -
                                              volume.at(glm::max(p - offset, glm::ivec3(0))));
                }
                const double magnitude = glm::length(worldFromVoxelGradient * difference);
                out.push_back(std::isfinite(magnitude) && std::isfinite(volume.at(p))
                                  ? magnitude
                                  : std::numeric_limits<double>::infinity());
            }
        }
    }
    return out;
}

} // namespace vs::reference

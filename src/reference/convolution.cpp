// SPDX-License-Identifier: Apache-2.0
#include "reference/convolution.h"

#include <algorithm>
#include <cmath>

namespace vs::reference {

std::vector<double> convolved(const volume::Volume& volume, double sigmaSteps) {
    const glm::ivec3 dims = volume.geometry.dims;
    const auto indexOf = [&](glm::ivec3 v) {
        return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
               std::size_t(v.x);
    };
    std::vector<double> values(volume.geometry.voxelCount());
    forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t n) { values[n] = volume.at(v); });
    for (int axis = 0; axis < 3; ++axis) {
        const double sigma = sigmaSteps * volume.geometry.stepMm() / volume.geometry.spacing()[axis];
        const int reach = std::max(1, int(std::ceil(3 * sigma)));
        const auto before = values;
        forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t n) {
            double sum = 0;
            double weights = 0;
            for (int d = -reach; d <= reach; ++d) {
                glm::ivec3 there = v;
                there[axis] = std::clamp(v[axis] + d, 0, dims[axis] - 1);
                const double value = before[indexOf(there)];
                const double w = std::erf((d + 0.5) / (sigma * std::sqrt(2))) -
                                 std::erf((d - 0.5) / (sigma * std::sqrt(2)));
                sum += std::isfinite(value) ? w * value : 0;
                weights += std::isfinite(value) ? w : 0;
            }
            values[n] = std::isfinite(before[n]) ? sum / weights : before[n];
        });
    }
    return values;
}

} // namespace vs::reference

// SPDX-License-Identifier: Apache-2.0
#include "reference/footprints.h"

#include <algorithm>
#include <cmath>

namespace vs::reference {

namespace {

// The overlap of the cell around `distance` with the box, of the box's length.
double share(double distance, double halfWidth) {
    const double lo = std::max(distance - 0.5, -halfWidth);
    const double hi = std::min(distance + 0.5, halfWidth);
    return hi > lo ? (hi - lo) / (2 * halfWidth) : 0;
}

double weight(int voxel, double position, double halfWidth) {
    const double low = std::floor(position);
    const double part = position - low;
    return (1 - part) * share(voxel - low, halfWidth) + part * share(voxel - low - 1, halfWidth);
}

} // namespace

std::vector<float> radiateCube(std::span<const glm::vec4> points, glm::ivec3 dims,
                               glm::dvec3 halfWidthVoxels) {
    std::vector<double> sum(Box3{glm::ivec3(0), dims}.volume(), 0.0);
    for (const glm::vec4& point : points) {
        const glm::dvec3 place(point);
        const glm::ivec3 lo = glm::max(glm::ivec3(glm::floor(place - halfWidthVoxels)) - 1, glm::ivec3(0));
        const glm::ivec3 hi = glm::min(glm::ivec3(glm::ceil(place + halfWidthVoxels)) + 2, dims);
        for (int z = lo.z; z < hi.z; ++z) {
            for (int y = lo.y; y < hi.y; ++y) {
                const double row = double(point.w) * weight(z, place.z, halfWidthVoxels.z) *
                                   weight(y, place.y, halfWidthVoxels.y);
                for (int x = lo.x; x < hi.x; ++x) {
                    sum[(std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) +
                        std::size_t(x)] += row * weight(x, place.x, halfWidthVoxels.x);
                }
            }
        }
    }
    return {sum.begin(), sum.end()};
}

} // namespace vs::reference

// SPDX-License-Identifier: Apache-2.0
#include "reference/trilinear.h"

namespace vs::reference {

namespace {

template <typename OfVoxel>
double between(const volume::Volume& volume, glm::dvec3 voxel, const OfVoxel& ofVoxel) {
    const glm::ivec3 dims = volume.geometry.dims;
    const glm::dvec3 last(dims - 1);
    const glm::dvec3 p = glm::clamp(voxel, glm::dvec3(0), last);
    const glm::dvec3 first = glm::min(glm::floor(p), glm::max(last - 1.0, glm::dvec3(0)));
    const glm::dvec3 f = p - first;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(offset));
        sum += w.x * w.y * w.z * ofVoxel(glm::min(glm::ivec3(first) + offset, dims - 1));
    }
    return sum;
}

} // namespace

double trilinearAt(const volume::Volume& volume, glm::dvec3 voxel) {
    return between(volume, voxel, [&](glm::ivec3 v) { return volume.at(v); });
}

double gradientBetween(const volume::Volume& volume, glm::dvec3 voxel) {
    return between(volume, voxel, [&](glm::ivec3 v) {
        glm::dvec3 gradient(0);
        for (int i = 0; i < 3; ++i) {
            glm::ivec3 e(0);
            e[i] = 1;
            const double after = volume.at(glm::min(v + e, volume.geometry.dims - 1));
            const double before = volume.at(glm::max(v - e, glm::ivec3(0)));
            gradient[i] = 0.5 * (after - before) / volume.geometry.spacing()[i];
        }
        return glm::length(gradient);
    });
}

} // namespace vs::reference

// SPDX-License-Identifier: Apache-2.0
#include "reference/bspline.h"

#include <cmath>

namespace vs::reference {

namespace {

// The basis function and its derivative at a distance from its centre.
double basis(double x) {
    const double d = std::abs(x);
    return d < 1 ? (4 - 6 * d * d + 3 * d * d * d) / 6 : d < 2 ? (2 - d) * (2 - d) * (2 - d) / 6 : 0;
}

double slope(double x) {
    const double d = std::abs(x);
    const double s = d < 1 ? -2 * d + 1.5 * d * d : d < 2 ? -0.5 * (2 - d) * (2 - d) : 0;
    return x < 0 ? -s : s;
}

} // namespace

SplineSample bsplineAt(const volume::Volume& volume, glm::dvec3 voxel) {
    const glm::ivec3 dims = volume.geometry.dims;
    const glm::ivec3 first = glm::ivec3(glm::floor(voxel)) - 1;
    double value = 0;
    glm::dvec3 gradient(0);
    for (int i = 0; i < 64; ++i) {
        const glm::ivec3 v = first + glm::ivec3(i % 4, i / 4 % 4, i / 16);
        const double stored = volume.at(glm::clamp(v, glm::ivec3(0), dims - 1));
        const glm::dvec3 d = voxel - glm::dvec3(v);
        const glm::dvec3 b(basis(d.x), basis(d.y), basis(d.z));
        value += stored * b.x * b.y * b.z;
        gradient +=
            stored * glm::dvec3(slope(d.x) * b.y * b.z, b.x * slope(d.y) * b.z, b.x * b.y * slope(d.z));
    }
    return {value, glm::transpose(glm::dmat3(volume.geometry.voxelFromWorld())) * gradient};
}

} // namespace vs::reference

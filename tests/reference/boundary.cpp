// SPDX-License-Identifier: Apache-2.0
#include "reference/boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vs::reference {

namespace {

struct Grid {
    std::span<const float> values;
    glm::ivec3 dims;
    glm::dvec3 stepsPerVoxel;

    [[nodiscard]] double at(glm::ivec3 v) const {
        v = glm::clamp(v, glm::ivec3(0), dims - 1);
        return values[(std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
                      std::size_t(v.x)];
    }
    [[nodiscard]] glm::dvec3 gradient(const glm::ivec3& v) const {
        const auto along = [&](const glm::ivec3& d) { return 0.5 * (at(v + d) - at(v - d)); };
        return glm::dvec3(along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})) / stepsPerVoxel;
    }
};

} // namespace

BoundaryErrors boundaryErrors(std::span<const float> values, const glm::ivec3& dims,
                              const glm::dvec3& stepsPerVoxel, const Boundary& boundary) {
    const Grid grid{values, dims, stepsPerVoxel};
    BoundaryErrors out;
    double squaredAngles = 0;
    const auto measure = [&](const glm::ivec3& a, const glm::ivec3& b) {
        const double from = grid.at(a);
        const double to = grid.at(b);
        if ((from >= 0.5) == (to >= 0.5)) {
            return;
        }
        const double t = (0.5 - from) / (to - from);
        const auto deviation = boundary(stepsPerVoxel * glm::mix(glm::dvec3(a), glm::dvec3(b), t));
        if (!deviation) {
            return;
        }
        const glm::dvec3 gradient = glm::mix(grid.gradient(a), grid.gradient(b), t);
        const double cosine = -glm::dot(gradient, deviation->normal) / glm::length(gradient);
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
        squaredAngles += angle * angle;
        out.mean += deviation->distance;
        out.rms += deviation->distance * deviation->distance;
        out.max = std::max(out.max, std::abs(deviation->distance));
        ++out.count;
    };
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                for (const glm::ivec3 d : {glm::ivec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}}) {
                    if (const glm::ivec3 b = glm::ivec3(x, y, z) + d; glm::all(glm::lessThan(b, dims))) {
                        measure({x, y, z}, b);
                    }
                }
            }
        }
    }
    const double count = std::max(out.count, 1);
    out.mean /= count;
    out.rms = std::sqrt(out.rms / count);
    out.normalAngle = std::sqrt(squaredAngles / count) * 180 / std::numbers::pi;
    return out;
}

} // namespace vs::reference

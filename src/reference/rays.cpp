// SPDX-License-Identifier: Apache-2.0
#include "reference/rays.h"

#include "reference/trilinear.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vs::reference {

Ray rayThrough(const volume::GridGeometry& geometry, glm::dvec3 origin, glm::dvec3 direction) {
    return rayThrough(geometry, origin, direction, glm::dvec3(geometry.dims) - 0.5);
}

Ray rayThrough(const volume::GridGeometry& geometry, glm::dvec3 origin, glm::dvec3 direction,
               glm::dvec3 upper) {
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    Ray ray{glm::dvec3(voxelFromWorld * glm::dvec4(origin, 1)),
            glm::dvec3(voxelFromWorld * glm::dvec4(direction * geometry.stepMm(), 0)),
            {0, std::numeric_limits<double>::infinity()}};
    for (int i = 0; i < 3; ++i) {
        const double inverse = 1 / (std::abs(ray.direction[i]) > 1e-15 ? ray.direction[i] : 1e-15);
        const double a = (-0.5 - ray.origin[i]) * inverse;
        const double b = (upper[i] - ray.origin[i]) * inverse;
        ray.way.lo = std::max(ray.way.lo, std::min(a, b));
        ray.way.hi = std::min(ray.way.hi, std::max(a, b));
    }
    return ray;
}

double greatestAlong(const volume::Volume& volume, const Ray& ray, double dt) {
    double best = -1;
    for (double k = std::ceil(ray.way.lo / dt - 0.5); (k + 0.5) * dt < ray.way.hi; ++k) {
        best = std::max(best, trilinearAt(volume, ray.at((k + 0.5) * dt)));
    }
    return best;
}

double integralAlong(const volume::Volume& volume, const Ray& ray, const Range& shown, double dt,
                     double shift) {
    double sum = 0;
    for (double k = std::ceil(ray.way.lo / dt - shift); (k + shift) * dt < ray.way.hi; ++k) {
        const double value = trilinearAt(volume, ray.at((k + shift) * dt));
        sum += shown.contains(value) ? (value - shown.lo) / shown.width() * dt : 0;
    }
    return sum;
}

glm::dvec4 compositeAlong(const volume::Volume& volume, const Ray& ray, const ColourOf& function, double dt,
                          double jitter) {
    glm::dvec4 sum(0);
    if (ray.way.hi <= ray.way.lo) {
        return sum;
    }
    for (double k = std::ceil(ray.way.lo / dt - jitter) - 1; (k + jitter) * dt < ray.way.hi; ++k) {
        const double from = std::clamp((k + jitter) * dt, ray.way.lo, ray.way.hi);
        const double to = std::clamp((k + 1 + jitter) * dt, ray.way.lo, ray.way.hi);
        const double front = trilinearAt(volume, ray.at(from));
        const double back = trilinearAt(volume, ray.at(to));
        const bool meetsNext = std::fmod(std::abs(k), 2.0) == 1;
        const double gradient = gradientBetween(volume, ray.at(meetsNext ? to : from));
        for (const double place : {0.25, 0.75}) {
            const glm::dvec4 c = function(glm::mix(front, back, place), gradient);
            const double a = 1 - std::pow(1 - c.w, 0.5 * (to - from));
            sum += (1 - sum.w) * a * glm::dvec4(glm::dvec3(c), 1);
        }
    }
    return sum;
}

} // namespace vs::reference

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"
#include "render/colours/transfer_function.h"
#include "volume/grid/volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vs::test {

// The way of a ray inside the grid's box, in mm from its origin: voxel borders, not centres. With `cutAt` the
// box ends at that voxel coordinate along `axis`.
inline Range wayInBox(const render::ViewRays::Ray& ray, const volume::GridGeometry& geometry, int axis = 0,
                      std::optional<double> cutAt = {}) {
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    const glm::dvec3 origin(voxelFromWorld * glm::dvec4(ray.origin, 1));
    const glm::dvec3 direction(voxelFromWorld * glm::dvec4(ray.direction, 0));
    glm::dvec3 upper = glm::dvec3(geometry.dims) - 0.5;
    upper[axis] = cutAt.value_or(upper[axis]);
    Range way{0, std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 3; ++i) {
        const double inverse = 1 / (std::abs(direction[i]) > 1e-15 ? direction[i] : 1e-15);
        const double a = (-0.5 - origin[i]) * inverse;
        const double b = (upper[i] - origin[i]) * inverse;
        way.lo = std::max(way.lo, std::min(a, b));
        way.hi = std::min(way.hi, std::max(a, b));
    }
    return way;
}

// How long that way is; 0 for a ray that misses the box.
inline double lengthInBox(const render::ViewRays& rays, glm::dvec2 pixel,
                          const volume::GridGeometry& geometry, int axis = 0,
                          std::optional<double> cutAt = {}) {
    const Range way = wayInBox(rays.through(pixel), geometry, axis, cutAt);
    return std::max(way.hi - way.lo, 0.0);
}

// Where the first sample of a pixel's ray lies, as a part of the way between two: the shader's arithmetic
// (cast_rays.comp), for the first sample of a picture.
inline double startJitter(glm::ivec2 pixel) {
    const glm::vec2 place = glm::vec2(pixel) + 64.0F * glm::vec2(0.5F);
    return double(glm::fract(52.9829189F * glm::fract(glm::dot(place, glm::vec2(0.06711056F, 0.00583715F)))));
}

// Rays through a volume without a device, sampled plainly: no skipping, no early end, double precision.
class CpuRays {
public:
    explicit CpuRays(const volume::Volume& volume) : volume_(volume) {}

    struct Ray {
        glm::dvec3 origin;    // voxel space
        glm::dvec3 direction; // voxel space, per step
        Range way;            // within the box, in steps
    };

    [[nodiscard]] Ray through(const render::ViewRays& rays, glm::dvec2 pixel) const {
        const auto ray = rays.through(pixel);
        const double step = volume_.geometry.stepMm();
        const Range way = wayInBox(ray, volume_.geometry);
        const glm::dmat4 voxelFromWorld = volume_.geometry.voxelFromWorld();
        return {glm::dvec3(voxelFromWorld * glm::dvec4(ray.origin, 1)),
                glm::dvec3(voxelFromWorld * glm::dvec4(ray.direction * step, 0)),
                {way.lo / step, way.hi / step}};
    }

    // Trilinear; beyond the outermost centres as there.
    [[nodiscard]] double valueAt(glm::dvec3 voxel) const {
        return between(voxel, [&](glm::ivec3 v) { return volume_.at(v); });
    }

    // Per mm: that of the voxels around, central differences one voxel wide. For grids along the world's
    // axes.
    [[nodiscard]] double gradientAt(glm::dvec3 voxel) const {
        return between(voxel, [&](glm::ivec3 v) {
            glm::dvec3 gradient(0);
            for (int i = 0; i < 3; ++i) {
                glm::ivec3 e(0);
                e[i] = 1;
                const double after = volume_.at(glm::min(v + e, volume_.geometry.dims - 1));
                const double before = volume_.at(glm::max(v - e, glm::ivec3(0)));
                gradient[i] = 0.5 * (after - before) / volume_.geometry.spacing()[i];
            }
            return glm::length(gradient);
        });
    }

    // The greatest of samples `dt` steps apart, the first half of that from the eye; below zero for a ray
    // that has none.
    [[nodiscard]] double greatest(const Ray& ray, double dt) const {
        double best = -1;
        for (double k = std::ceil(ray.way.lo / dt - 0.5); (k + 0.5) * dt < ray.way.hi; ++k) {
            best = std::max(best, valueAt(ray.origin + (k + 0.5) * dt * ray.direction));
        }
        return best;
    }

    // Premultiplied linear colour and opacity, unlit: pieces between samples `dt` steps apart, along which
    // the value goes evenly, each with two looks at the function; opacities are per step. Two pieces share
    // the gradient of the sample where they meet, which has an even number.
    [[nodiscard]] glm::dvec4 composite(const Ray& ray, const render::FunctionSampler& function, double dt,
                                       double jitter) const {
        glm::dvec4 sum(0);
        if (ray.way.hi <= ray.way.lo) {
            return sum;
        }
        for (double k = std::ceil(ray.way.lo / dt - jitter) - 1; (k + jitter) * dt < ray.way.hi; ++k) {
            const double from = std::clamp((k + jitter) * dt, ray.way.lo, ray.way.hi);
            const double to = std::clamp((k + 1 + jitter) * dt, ray.way.lo, ray.way.hi);
            const double front = valueAt(ray.origin + from * ray.direction);
            const double back = valueAt(ray.origin + to * ray.direction);
            const bool meetsNext = std::fmod(std::abs(k), 2.0) == 1;
            const double gradient = gradientAt(ray.origin + (meetsNext ? to : from) * ray.direction);
            for (const double place : {0.25, 0.75}) {
                const glm::dvec4 c = function.at(glm::mix(front, back, place), gradient);
                const double a = render::opacityOver(c.w, 0.5 * (to - from));
                sum += (1 - sum.w) * a * glm::dvec4(glm::dvec3(c), 1);
            }
        }
        return sum;
    }

private:
    template <typename OfVoxel>
    [[nodiscard]] double between(glm::dvec3 voxel, const OfVoxel& ofVoxel) const {
        const glm::dvec3 last(volume_.geometry.dims - 1);
        const glm::dvec3 p = glm::clamp(voxel, glm::dvec3(0), last);
        const glm::dvec3 first = glm::min(glm::floor(p), glm::max(last - 1.0, glm::dvec3(0)));
        const glm::dvec3 f = p - first;
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
            const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(offset));
            sum += w.x * w.y * w.z * ofVoxel(glm::min(glm::ivec3(first) + offset, volume_.geometry.dims - 1));
        }
        return sum;
    }

    const volume::Volume& volume_;
};

} // namespace vs::test

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <functional>

// Rays through a volume without a device, sampled plainly: no skipping, no early end, double precision.
namespace vs::reference {

// A ray in voxel space. Its parameter counts steps, the smallest spacings.
struct Ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0}; // voxels a step
    Range way;               // within the grid's box, voxel borders and not centres; empty: it misses the box

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

// The ray from a place of the world (mm) in a unit direction. With `upper` the box ends at those voxel
// coordinates instead of the grid's.
Ray rayThrough(const volume::GridGeometry& geometry, glm::dvec3 origin, glm::dvec3 direction);
Ray rayThrough(const volume::GridGeometry& geometry, glm::dvec3 origin, glm::dvec3 direction,
               glm::dvec3 upper);

// The greatest of samples `dt` steps apart, the first half of that from the eye; below zero for a ray that
// has none.
double greatestAlong(const volume::Volume& volume, const Ray& ray, double dt);

// The integral of the part of `shown` that a value lies at, from 0 to 1, over where values lie in it, in
// steps: samples `dt` apart, the first `shift` of that from the eye.
double integralAlong(const volume::Volume& volume, const Ray& ray, const Range& shown, double dt,
                     double shift);

// Premultiplied linear colour and opacity, unlit: pieces between samples `dt` steps apart, along which the
// value goes evenly, each with two looks at the function; opacities are per step. Two pieces share the
// gradient of the sample where they meet, which has an even number. `function` gives linear colour and
// opacity of a value and a gradient magnitude, `jitter` says where the first sample lies, as a part of `dt`.
using ColourOf = std::function<glm::dvec4(double value, double gradient)>;
glm::dvec4 compositeAlong(const volume::Volume& volume, const Ray& ray, const ColourOf& function, double dt,
                          double jitter);

} // namespace vs::reference

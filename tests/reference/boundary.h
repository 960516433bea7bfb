// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <span>

namespace vs::reference {

// Where a point lies to the true boundary: its distance, and the boundary's unit normal there, which points
// outwards. Lengths in steps.
struct Deviation {
    double distance = 0;
    glm::dvec3 normal{0};
};
using Boundary = std::function<std::optional<Deviation>(const glm::dvec3& p)>; // nothing: not to be measured

// How far the 0.5 level of a grid of values (x fastest) is from a true boundary, at every edge between
// neighbouring voxels that it crosses (there linear interpolation is what pictures show).
struct BoundaryErrors {
    int count = 0;
    double mean = 0; // signed, outwards positive, steps
    double rms = 0;
    double max = 0;
    // Root mean square angle, in degrees, between the boundary's normal and the central-difference gradient,
    // interpolated as pictures shade with it: the roughness that one sees.
    double normalAngle = 0;
};
BoundaryErrors boundaryErrors(std::span<const float> values, const glm::ivec3& dims,
                              const glm::dvec3& stepsPerVoxel, const Boundary& boundary);

} // namespace vs::reference

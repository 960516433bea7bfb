// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace vs::segment {

// An axis of the solid ellipsoid that has the volume's moments: as long as the segment would be, were it one.
struct PrincipalAxis {
    glm::dvec3 direction{0}; // world (LPS), unit; of its two ways the one whose largest part is positive
    double lengthMm = 0;     // the whole axis
};

// The longest first. `covarianceMm2`: of the places in a solid (world), each part of it counted by its
// volume. Half an axis of a solid ellipsoid is the square root of five times the variance along it.
std::array<PrincipalAxis, 3> principalAxes(const glm::dmat3& covarianceMm2);

// How close to a ball a solid is: the surface of a ball of its volume by its own surface (Wadell 1935); 1 for
// a ball, less for all else. Surfaces that are measured a little too small, as those of a few voxels are,
// give a little more.
double sphericity(double millilitres, double surfaceMm2);

} // namespace vs::segment

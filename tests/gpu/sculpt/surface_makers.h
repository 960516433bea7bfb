// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "sculpt/mask/mask.h"

#include <functional>
#include <optional>
#include <vector>

namespace vs::test {

// What a ray meets: position in voxel space and unit normal in world space.
struct SurfaceHit {
    glm::dvec3 voxel;
    glm::dvec3 normal;
};

// Surface points under a mask, from an analytic surface: `hit` is asked at each element's centre, in the
// mask's unit.
std::vector<field::SurfacePoint>
surfaceUnder(const sculpt::MaskRaster& mask, const std::function<std::optional<SurfaceHit>(glm::dvec2)>& hit);

// Rays along +z in voxel space meet the plane z = height (normal -z, towards the viewer).
std::vector<field::SurfacePoint> slabUnder(const sculpt::MaskRaster& mask, double height);

// Rays along +z meet the outside of a sphere, or its inside (from within a hollow sphere, rays from the
// centre: the mask is then in tangents of angles).
std::vector<field::SurfacePoint> sphereUnder(const sculpt::MaskRaster& mask, glm::dvec3 centre,
                                             double radius);
std::vector<field::SurfacePoint> hollowSphereUnder(const sculpt::MaskRaster& mask, glm::dvec3 centre,
                                                   double radius);

// Trilinear samples of dims values (x fastest), and where along a ray they fall through 0.5 (they must be
// above at 0 and below at `reach`).
float sampleGrid(const std::vector<float>& values, glm::ivec3 dims, glm::dvec3 p);
double crossingOf(const std::vector<float>& values, glm::ivec3 dims, glm::dvec3 from, glm::dvec3 way,
                  double reach);

} // namespace vs::test

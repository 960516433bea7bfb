// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <glm/glm.hpp>

#include <array>

namespace vs::sculpt {

// How one axis spreads a point's energy: it is first deposited by a B-spline (degree 1, 2 or 3) into the
// voxels next to it and then convolved with symmetric taps, which together stand for the Gaussian. taps[0] is
// the middle; they sum to 1.
struct AxisFootprint {
    static constexpr int kMaxReach = 4;
    int degree = 2;
    int reach = 0; // taps on either side of the middle
    std::array<float, kMaxReach + 1> taps{1, 0, 0, 0, 0};
};

// The spread of a radiated point, as FootprintShape says, in the voxels of a grid: fewer along axes of wider
// spacing. Axes too coarse to hold a Gaussian take the narrowest spread that still keeps the point's centre,
// a linear B-spline, unless the shape says otherwise.
struct Footprint {
    int radius = 3;            // in steps: 2, 3 or 4
    glm::dvec3 sigmaVoxels{1}; // standard deviations
    std::array<AxisFootprint, 3> axes;

    // Voxels on either side of the one that holds a point which its energy can reach.
    [[nodiscard]] glm::ivec3 reachVoxels() const;
};

enum class FootprintKind { Gaussian, Ellipsoid, Cube };
// The names of footprint shapes on command lines, in the order of the enumeration.
inline constexpr std::array<const char*, 3> kFootprintKinds{"gaussian", "ellipsoid", "cube"};

// What a point's energy is spread over (doc/behaviour.md, "Point radiation"), in steps, hence the same in
// millimetres on every spacing:
// - Gaussian: sigma = radius / 3 along every axis.
// - Ellipsoid: a Gaussian of `sigmaSteps` along each axis of the grid, the axis-aligned form of the
//   elliptical kernels of Zwicker et al. 2001 ("EWA volume splatting").
// - Cube: a box of half-width `radius`, its faces as soft as linear interpolation between voxels makes them.
struct FootprintShape {
    static constexpr double kMaxSigmaVoxels = 4.0 / 3; // three of them are AxisFootprint::kMaxReach

    FootprintKind kind = FootprintKind::Gaussian;
    int radius = 3;           // 2, 3 or 4; not for the ellipsoid
    glm::dvec3 sigmaSteps{1}; // of the ellipsoid: above 0, at most kMaxSigmaVoxels
    // Axes too coarse to hold a Gaussian take a quadratic B-spline: wider, but its softer edges are more
    // exact where pictures interpolate linearly between slices (three steps apart: 0.065 steps rms against
    // 0.087). For solids made from nothing; tools, whose cuts must reach the last slice, take the narrowest.
    bool isSmoothWhereCoarse = false;
};

// The footprint of a shape on a grid of `spacing` (mm). The taps of Gaussians are fitted by least squares
// over all places of a point between voxels, against the truncated normalised Gaussian of referenceWeights();
// those of the cube are exact.
Footprint fitFootprint(const FootprintShape& shape, glm::dvec3 spacing = glm::dvec3(1.0));

// What points in a box of voxels can reach, and the points of which box can reach it.
inline Box3 reachOf(const Box3& box, const Footprint& footprint) {
    const glm::ivec3 reach = footprint.reachVoxels() + 1;
    return {box.lo - reach, box.hi + reach};
}

// The Gaussian footprint of a radius, which must be 2, 3 or 4.
Footprint fitFootprint(int radius, glm::dvec3 spacing = glm::dvec3(1.0));

// The definition that the fast radiation is fitted to (doc/behaviour.md, "Point radiation"; thesis,
// section 3.4.1): weights along one axis of the 2 * halfWidth voxels around a point at `offset` (in [0, 1))
// beyond voxel 0; element n belongs to voxel n + 1 - halfWidth. The weights sum to 1.
struct ReferenceWeights {
    int halfWidth = 3;
    std::array<double, 10> weights{};
};
// The weights of a Gaussian of `sigma` voxels, at most kMaxSigmaVoxels.
ReferenceWeights referenceWeights(double sigma, double offset);
// The weights of a box of half-width `halfWidthVoxels`, at most AxisFootprint::kMaxReach: the parts of the
// voxels' cells that it covers when centred on a voxel, interpolated linearly between voxels.
ReferenceWeights cubeReferenceWeights(double halfWidthVoxels, double offset);

} // namespace vs::sculpt

// SPDX-License-Identifier: Apache-2.0
#pragma once

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

// The spread of a radiated point: a Gaussian of sigma = radius / 3 steps, isotropic in millimetres, so fewer
// voxels along axes of wider spacing (sigmaVoxels). Axes too coarse to hold the Gaussian take the narrowest
// spread that still keeps the point's centre, a linear B-spline.
struct Footprint {
    int radius = 3; // in steps: 2, 3 or 4
    glm::dvec3 sigmaVoxels{1};
    std::array<AxisFootprint, 3> axes;

    // Voxels on either side of the one that holds a point which its energy can reach.
    [[nodiscard]] glm::ivec3 reachVoxels() const;
};

// Fits the taps by least squares over all places of a point between voxels, against the truncated normalised
// Gaussian of referenceWeights(). `spacing` in mm. `radius` must be 2, 3 or 4.
Footprint fitFootprint(int radius, glm::dvec3 spacing = glm::dvec3(1.0));

// The definition that the fast radiation is fitted to (SPEC 4, thesis 3.4): weights along one axis of the 2 *
// halfWidth voxels around a point at `offset` (in [0, 1)) beyond voxel 0; element n belongs to voxel n + 1 -
// halfWidth. The weights are a Gaussian of `sigma` voxels, and sum to 1.
struct ReferenceWeights {
    int halfWidth = 3;
    std::array<double, 8> weights{};
};
ReferenceWeights referenceWeights(double sigma, double offset);

} // namespace vs::sculpt

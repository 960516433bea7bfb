// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/wall_voxels.h"

#include <array>
#include <span>

namespace vs::segment {

// The wall of a vessel around one point of its axis, s along it from there: radius = level + slope s + bend
// s^2
// + for m = 1 ... : cosines[m-1] cos m a + sines[m-1] sin m a. In mm.
struct WallShape {
    static constexpr std::size_t kHarmonics = 4;
    static constexpr std::size_t kNumbers = 3 + 2 * kHarmonics;
    std::array<double, kNumbers> numbers{}; // level, slope, bend, then cosine and sine of each harmonic

    [[nodiscard]] double level() const { return numbers[0]; }
    [[nodiscard]] double radiusMm(double angle) const; // at s = 0
};

struct WallFit {
    double alongMm = 0; // of the point of the axis
    double sigmaMm = 1; // how far along voxels count: the Gaussian's
    double stepMm = 1;  // the smallest spacing
    std::size_t harmonics = 3;
    double expectedMm = 1; // the radius, to begin with
};

// The likeliest wall. Voxels come in groups in the order of their alongMm, as wallVoxels() has them.
WallShape fittedWall(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit);

} // namespace vs::segment

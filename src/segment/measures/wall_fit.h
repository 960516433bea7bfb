// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/wall_footprint.h"

#include <array>
#include <span>

namespace vs::segment {

// The wall of a vessel around one point of its axis, s along it from there: radius = level + slope s + bend
// s^2
// + for m = 1 ... : cosines[m-1] cos m a + sines[m-1] sin m a. In mm.
struct WallShape {
    static constexpr std::size_t kHarmonics = 4;
    static constexpr std::size_t kNumbers = 4 + 2 * kHarmonics;
    // Where each number stands; behind them cosine and sine of each harmonic.
    static constexpr std::size_t kFull = 0;
    static constexpr std::size_t kLevel = 1;
    static constexpr std::size_t kSlope = 2;
    static constexpr std::size_t kBend = 3;
    std::array<double, kNumbers> numbers{};

    // The share (WallVoxel) of a voxel that is all inside.
    [[nodiscard]] double full() const { return numbers[kFull]; }
    [[nodiscard]] double level() const { return numbers[kLevel]; }
    [[nodiscard]] double radiusMm(double angle) const;                             // at s = 0
    [[nodiscard]] double radiusAtMm(const WallVoxel& voxel, double alongMm) const; // s = 0 at `alongMm`
};

struct WallFit {
    double alongMm = 0; // of the point of the axis
    double sigmaMm = 1; // how far along voxels count: the Gaussian's
    double stepMm = 1;  // the smallest spacing
    std::size_t harmonics = 3;
    double expectedMm = 1;   // the radius, to begin with
    double shareNoise = 0.1; // standard deviation
    Footprint footprint;     // for shares
};

// The likeliest wall. Voxels come in groups in the order of their alongMm, as wallVoxels() has them.
WallShape fittedWall(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit);

// Takes a wall to where it leaves of each voxel the part inside that its share tells. Of voxels without a
// share it counts whether they are inside.
WallShape wallByShares(std::span<const std::vector<WallVoxel>> groups, const WallFit& fit, WallShape wall);

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/noise.h"
#include "phantom/scanner.h"
#include "phantom/tissue_painter.h"

#include <cmath>
#include <string>

namespace vs::phantom {

// What a made body is scanned with by CT.
struct CtScan {
    glm::ivec3 dims{128};
    glm::dvec3 extentMm{400};
    double noisePercent = 0; // standard deviation in percent of 1000 HU
    std::uint64_t seed = 1;
};

// A CT scan (int16, Hounsfield units) of what `paint(place, voxelMm, number)` paints at each place, in mm
// from the grid's middle (x to the left, y backwards, z up), in the voxel of that number (x fastest): a
// TissuePainter that has painted. `paint` is kept, and called by several threads at once.
template <typename Paint>
Scanner ctScanner(const CtScan& scan, std::string name, Paint paint) {
    const auto grid = phantomGrid(scan.dims, scan.extentMm);
    const double voxelMm = std::cbrt(grid.voxelMm3());
    const double sigma = 10 * scan.noisePercent;
    return scannerOf<std::int16_t>(
        std::move(name), grid, volume::ScalarType::Int16,
        [=, seed = scan.seed](glm::dvec3 p, std::size_t n) -> Measured {
            const TissuePainter painted = paint(p, voxelMm, n);
            const double noise = sigma > 0 ? sigma * normalPair(seed, n).x : 0;
            return {std::floor(std::clamp(painted.value() + noise, -1024.0, 3071.0) + 0.5), painted.label()};
        });
}

} // namespace vs::phantom

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/parallel.h"
#include "phantom/head_phantom.h"
#include "phantom/noise.h"
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
// TissuePainter that has painted. Always the same for the same scan, however many threads make it.
template <typename Paint>
LabelledVolume scanByCt(const CtScan& scan, std::string name, const Paint& paint) {
    LabelledVolume scanned;
    const auto grid = scanned.volume.geometry = phantomGrid(scan.dims, scan.extentMm);
    const double voxelMm = std::cbrt(grid.voxelMm3());
    const double sigma = 10 * scan.noisePercent;
    scanned.volume.type = volume::ScalarType::Int16;
    scanned.volume.name = std::move(name);
    scanned.volume.bytes.resize(grid.voxelCount() * sizeof(std::int16_t));
    scanned.labels.resize(grid.voxelCount());
    auto* values = reinterpret_cast<std::int16_t*>(scanned.volume.bytes.data());
    const std::size_t slice = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
    inParallel(grid.dims.z, [&](int z) {
        std::size_t n = slice * std::size_t(z);
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x, ++n) {
                const auto p = glm::dvec3(grid.worldFromVoxel * glm::dvec4(x, y, z, 1));
                const TissuePainter painted = paint(p, voxelMm, n);
                const double noise = sigma > 0 ? sigma * normalPair(scan.seed, n).x : 0;
                values[n] =
                    std::int16_t(std::floor(std::clamp(painted.value() + noise, -1024.0, 3071.0) + 0.5));
                scanned.labels[n] = painted.label();
            }
        }
    });
    volume::computeRange(scanned.volume);
    return scanned;
}

} // namespace vs::phantom

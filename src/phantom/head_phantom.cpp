// SPDX-License-Identifier: Apache-2.0
#include "phantom/head_phantom.h"

#include "base/parallel.h"
#include "phantom/noise.h"

#include <cmath>

namespace vs::phantom {

namespace {

constexpr glm::dvec3 kHeadExtentMm(181, 217, 181);

// A smooth field over the head, of no particular scale; `p` in mm from its middle.
double sensitivity(glm::dvec3 p) {
    const glm::dvec3 q = p / 90.0;
    return std::cos(1.3 * q.x + 0.7) + 0.8 * std::sin(1.1 * q.y - 0.4 * q.z) +
           0.7 * std::cos(1.2 * q.z + 0.5 * q.x) + 0.25 * q.x * q.y;
}

bool isBrain(std::uint8_t label) { return label >= std::uint8_t(HeadTissue::Csf); }

// The range of the sensitivity over the brain and the fluid around it.
Range sensitivityRange(const volume::GridGeometry& grid, double voxelMm) {
    std::vector<Range> ofSlices(std::size_t(grid.dims.z), Range{1e9, -1e9});
    inParallel(grid.dims.z, [&](int z) {
        Range& range = ofSlices[std::size_t(z)];
        forEachVoxel({{0, 0, z}, {grid.dims.x, grid.dims.y, z + 1}}, [&](glm::ivec3 v, std::size_t) {
            const auto p = glm::dvec3(grid.worldFromVoxel * glm::dvec4(v, 1));
            if (isBrain(paintHead(p, voxelMm).label())) {
                const double s = sensitivity(p);
                range = {std::min(range.lo, s), std::max(range.hi, s)};
            }
        });
    });
    Range range{1e9, -1e9};
    for (const Range& ofSlice : ofSlices) {
        range = {std::min(range.lo, ofSlice.lo), std::max(range.hi, ofSlice.hi)};
    }
    return range.hi > range.lo ? range : Range{0, 1};
}

} // namespace

Scanner headScanner(const HeadPhantomOptions& options) {
    const auto grid = phantomGrid(options.dims, kHeadExtentMm);
    const double voxelMm = std::cbrt(grid.voxelMm3());
    const Range range = options.biasPercent > 0 ? sensitivityRange(grid, voxelMm) : Range{0, 1};
    const double sigma = 0.01 * options.noisePercent * t1::white;
    return scannerOf<std::uint8_t>(
        "head phantom", grid, volume::ScalarType::UInt8,
        [options, voxelMm, range, sigma](glm::dvec3 p, std::size_t n) -> Measured {
            const TissuePainter painted = paintHead(p, voxelMm);
            const double middle =
                options.biasPercent > 0 ? (sensitivity(p) - range.lo) / range.width() - 0.5 : 0;
            double value =
                std::max(1 + 0.01 * options.biasPercent * middle, 0.0) * double(float(painted.value()));
            if (sigma > 0) {
                const glm::dvec2 noise = sigma * normalPair(options.seed, n);
                value = std::hypot(value + noise.x, noise.y);
            }
            return {std::clamp(std::floor(value + 0.5), 0.0, 255.0), painted.label()};
        });
}

LabelledVolume makeHeadPhantom(const HeadPhantomOptions& options) { return scanAll(headScanner(options)); }

} // namespace vs::phantom

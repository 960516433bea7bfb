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
Range sensitivityRange(const volume::GridGeometry& grid, const std::vector<std::uint8_t>& labels) {
    Range range{1e9, -1e9};
    std::size_t n = 0;
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x, ++n) {
                if (isBrain(labels[n])) {
                    const double s = sensitivity(glm::dvec3(grid.worldFromVoxel * glm::dvec4(x, y, z, 1)));
                    range = {std::min(range.lo, s), std::max(range.hi, s)};
                }
            }
        }
    }
    return range.hi > range.lo ? range : Range{0, 1};
}

} // namespace

volume::GridGeometry phantomGrid(glm::ivec3 dims, glm::dvec3 extentMm) {
    auto grid = volume::makeGeometry(dims, extentMm / glm::dvec3(dims));
    grid.worldFromVoxel[3] = glm::dvec4(0.5 * (grid.spacing() - extentMm), 1);
    return grid;
}

LabelledVolume makeHeadPhantom(const HeadPhantomOptions& options) {
    LabelledVolume head;
    const auto grid = head.volume.geometry = phantomGrid(options.dims, kHeadExtentMm);
    const double voxelMm = std::cbrt(grid.voxelMm3());
    head.volume.name = "head phantom";
    head.labels.resize(grid.voxelCount());
    std::vector<float> clean(grid.voxelCount());
    const std::size_t slice = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
    const auto forEachVoxel = [&](const auto& visitVoxel) {
        inParallel(grid.dims.z, [&](int z) {
            std::size_t n = slice * std::size_t(z);
            for (int y = 0; y < grid.dims.y; ++y) {
                for (int x = 0; x < grid.dims.x; ++x, ++n) {
                    visitVoxel(n, glm::dvec3(grid.worldFromVoxel * glm::dvec4(x, y, z, 1)));
                }
            }
        });
    };
    forEachVoxel([&](std::size_t n, glm::dvec3 p) {
        const TissuePainter painted = paintHead(p, voxelMm);
        clean[n] = float(painted.value());
        head.labels[n] = painted.label();
    });
    const Range range = options.biasPercent > 0 ? sensitivityRange(grid, head.labels) : Range{0, 1};
    const double sigma = 0.01 * options.noisePercent * t1::white;
    head.volume.bytes.resize(grid.voxelCount());
    forEachVoxel([&](std::size_t n, glm::dvec3 p) {
        const double middle = options.biasPercent > 0 ? (sensitivity(p) - range.lo) / range.width() - 0.5 : 0;
        double value = std::max(1 + 0.01 * options.biasPercent * middle, 0.0) * double(clean[n]);
        if (sigma > 0) {
            const glm::dvec2 noise = sigma * normalPair(options.seed, n);
            value = std::hypot(value + noise.x, noise.y);
        }
        head.volume.bytes[n] = std::byte(std::uint8_t(std::clamp(std::floor(value + 0.5), 0.0, 255.0)));
    });
    volume::computeRange(head.volume);
    return head;
}

} // namespace vs::phantom

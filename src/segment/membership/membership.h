// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/geometry.h"

#include <array>
#include <cstdint>
#include <span>

namespace vs::segment {

// Voxels that the kernel which makes segments smooth reaches to either side.
inline constexpr int kKernelReach = 3;

// Weights, by distance in voxels, of the separable Gaussian that makes segments smooth: normalised, sigma R/3
// steps with R = 3, the same in mm along all axes.
glm::vec4 smoothingKernel(double stepMm, double spacingMm);

// How much voxels belong to one segment alone, in [0, 1]: what Segmentation is on the device for all segments
// that are shown together, found voxel by voxel where it is asked for, and without rounding to 8 bits. The
// segment's smooth surface is at 0.5, which no voxel has: those of the segment have more, all others less.
class Membership {
public:
    // `labels`, one for each voxel of the grid (x fastest), must outlive this.
    Membership(std::span<const std::uint8_t> labels, const volume::GridGeometry& geometry,
               std::uint8_t label);

    // `voxel` must be inside the grid.
    [[nodiscard]] double at(glm::ivec3 voxel) const;

private:
    std::span<const std::uint8_t> labels_;
    glm::ivec3 dims_;
    std::uint8_t label_;
    std::array<glm::vec4, 3> weights_; // by axis
};

} // namespace vs::segment

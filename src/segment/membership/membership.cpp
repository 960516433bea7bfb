// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/membership.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vs::segment {

namespace {

constexpr double kRadiusSteps = 3.0;
constexpr double kHalfTexel = 0.5 / 255; // voxels are at least as far from 0.5 as in 8 bits

} // namespace

// The spacing is at least one step, so sigma is at most a voxel and 3 voxels hold all of it that 16 bits
// show.
glm::vec4 smoothingKernel(double stepMm, double spacingMm) {
    const double sigma = kRadiusSteps / 3.0 * stepMm / spacingMm;
    double weights[kKernelReach + 1];
    double sum = 0;
    for (int i = 0; i <= kKernelReach; ++i) {
        weights[i] = std::exp(-0.5 * i * i / (sigma * sigma));
        sum += i == 0 ? weights[i] : 2 * weights[i];
    }
    return glm::vec4(glm::dvec4(weights[0], weights[1], weights[2], weights[3]) / sum);
}

Membership::Membership(std::span<const std::uint8_t> labels, const volume::GridGeometry& geometry,
                       std::uint8_t label)
    : labels_(labels), dims_(geometry.dims), label_(label) {
    VS_CHECK_EQ(labels.size(), geometry.voxelCount());
    const glm::dvec3 spacing = geometry.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        weights_[std::size_t(axis)] = smoothingKernel(geometry.stepMm(), spacing[axis]);
    }
}

double Membership::at(glm::ivec3 voxel) const {
    const auto rowAt = [this](int y, int z) {
        return labels_.data() +
               (std::size_t(z) * std::size_t(dims_.y) + std::size_t(y)) * std::size_t(dims_.x);
    };
    const glm::ivec3 lo = glm::max(voxel - kKernelReach, glm::ivec3(0));
    const glm::ivec3 hi = glm::min(voxel + kKernelReach, dims_ - 1);
    double sum = 0;
    for (int z = lo.z; z <= hi.z; ++z) {
        for (int y = lo.y; y <= hi.y; ++y) {
            const std::uint8_t* row = rowAt(y, z);
            float alongX = 0;
            for (int x = lo.x; x <= hi.x; ++x) {
                alongX += row[x] == label_ ? weights_[0][std::abs(x - voxel.x)] : 0.0F;
            }
            sum += double(alongX * weights_[1][std::abs(y - voxel.y)] * weights_[2][std::abs(z - voxel.z)]);
        }
    }
    // Held to the truth by mirroring at 0.5.
    return rowAt(voxel.y, voxel.z)[voxel.x] == label_ ? std::max({sum, 1 - sum, 0.5 + kHalfTexel})
                                                      : std::min({sum, 1 - sum, 0.5 - kHalfTexel});
}

} // namespace vs::segment

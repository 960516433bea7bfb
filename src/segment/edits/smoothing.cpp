// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/smoothing.h"

#include "base/error.h"
#include "segment/edits/separable.h"

#include <cmath>
#include <numeric>

namespace vs::segment {
namespace {

// A Gaussian's share in each voxel, to three sigma on both sides.
std::vector<float> gaussian(double sigmaVoxels) {
    const int reach = int(std::ceil(3 * sigmaVoxels));
    const auto below = [&](double x) { return std::erf(x / (sigmaVoxels * std::sqrt(2.0))); };
    std::vector<float> weights;
    for (int k = -reach; k <= reach; ++k) {
        weights.push_back(reach == 0 ? 1.0F : float(below(k + 0.5) - below(k - 0.5)));
    }
    const float sum = std::accumulate(weights.begin(), weights.end(), 0.0F);
    for (float& weight : weights) {
        weight /= sum;
    }
    return weights;
}

} // namespace

void checkSmoothing(const volume::GridGeometry& geometry, double mm) {
    const auto spacing = geometry.spacing();
    const double largestMm = 100 * std::max({spacing.x, spacing.y, spacing.z});
    if (!(mm >= 0 && mm <= largestMm)) {
        throw Error("smoothing by {} mm is not possible here; it must lie between 0 and {:.4g} mm", mm,
                    largestMm);
    }
}

glm::ivec3 smoothingReach(const volume::GridGeometry& geometry, double mm) {
    return glm::ivec3(glm::ceil(3.0 * (mm / geometry.spacing()))); // as gaussian() has it
}

VoxelSet smooth(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    checkSmoothing(geometry, mm);
    const Box3 tight = set.tightBox();
    if (tight.isEmpty()) {
        return {};
    }
    const auto spacing = geometry.spacing();
    // The outermost layer stays empty: it is what goes on beyond the box.
    const glm::ivec3 padding = smoothingReach(geometry, mm) + 1;
    VoxelSet result = set.within(vs::intersect(Box3{tight.lo - padding, tight.hi + padding}, geometry.box()));
    const auto blur = [&](std::vector<float>& values) {
        for (int axis = 0; axis < 3; ++axis) {
            filterAlong(axis, values, result.box.size(), gaussian(mm / spacing[axis]), 0.0F,
                        [](float sum, float neighbour, float weight) { return sum + weight * neighbour; });
        }
    };
    std::vector<float> once(result.inside.begin(), result.inside.end());
    blur(once);
    std::vector<float> twice = once;
    blur(twice);
    std::transform(once.begin(), once.end(), twice.begin(), result.inside.begin(),
                   [](float a, float b) { return std::uint8_t(2 * a - b >= 0.5F ? 1 : 0); });
    return result.tight();
}

} // namespace vs::segment

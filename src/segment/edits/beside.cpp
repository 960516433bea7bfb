// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/beside.h"

#include "segment/edits/separable.h"

#include <algorithm>
#include <cstddef>

namespace vs::segment {

namespace {

// 1 within `reach` voxels of a mask's, along any axes.
std::vector<float> reached(const std::vector<std::uint8_t>& mask, glm::ivec3 size, int reach) {
    std::vector<float> values(mask.begin(), mask.end());
    const std::vector<float> weights(std::size_t(2 * reach + 1), 1.0F);
    for (int axis = 0; axis < 3; ++axis) {
        filterAlong(axis, values, size, weights, 0.0F,
                    [](float most, float value, float weight) { return std::max(most, value * weight); });
    }
    return values;
}

} // namespace

std::vector<float> besideIslands(const std::vector<std::uint8_t>& islands,
                                 const std::vector<std::uint8_t>& kept, const Box3& box) {
    const Box3 around = grow(box, kBeside);
    const std::vector<float> gone = reached(islands, around.size(), kBeside);
    const std::vector<float> fence = reached(kept, around.size(), 1);
    std::vector<float> values(box.volume());
    const glm::ivec3 size = around.size();
    forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t n) {
        const glm::ivec3 at = voxel - around.lo;
        const std::size_t i =
            (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
            std::size_t(at.x);
        values[n] = fence[i] > 0 ? 0.0F : gone[i];
    });
    return values;
}

} // namespace vs::segment

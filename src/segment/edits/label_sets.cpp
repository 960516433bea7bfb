// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/label_sets.h"

#include <algorithm>

namespace vs::segment {

std::array<Box3, 256> labelBoxes(std::span<const std::uint8_t> labels, glm::ivec3 dims) {
    std::array<Box3, 256> boxes{};
    auto voxel = labels.begin();
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            const auto row = voxel;
            const auto end = row + dims.x;
            while (voxel != end) { // run by run of equal labels
                const std::uint8_t label = *voxel;
                const auto next = std::find_if(voxel, end, [label](auto other) { return other != label; });
                if (label != 0) {
                    boxes[label] =
                        unite(boxes[label], {{int(voxel - row), y, z}, {int(next - row), y + 1, z + 1}});
                }
                voxel = next;
            }
        }
    }
    return boxes;
}

VoxelSet setOf(std::span<const std::uint8_t> labels, glm::ivec3 dims, std::uint8_t label, const Box3& box) {
    VoxelSet set = emptySet(box);
    auto inside = set.inside.begin();
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            const auto row = (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
            const auto values = labels.subspan(row + std::size_t(box.lo.x), std::size_t(box.size().x));
            inside = std::transform(values.begin(), values.end(), inside,
                                    [label](auto value) { return std::uint8_t(value == label ? 1 : 0); });
        }
    }
    return set;
}

} // namespace vs::segment

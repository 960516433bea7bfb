// SPDX-License-Identifier: Apache-2.0
#include "field/fill/fill_labels.h"

namespace vs::field {

std::vector<std::uint8_t> materialLabels(const Fill& fill) {
    const glm::ivec3 n = fill.dims();
    std::vector<std::uint8_t> labels(std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z), 0);
    for (const auto& entry : fill.bricks().entries()) {
        const glm::ivec3 lo = fill.brickAt(entry.first) * kFillBrick;
        forEachVoxel(fill.boxOf(entry.first), [&](glm::ivec3 v, std::size_t) {
            const std::size_t i = FillBrick::index(v - lo);
            if (entry.second->filled[i] >= kHalfFilled) {
                labels[(std::size_t(v.z) * std::size_t(n.y) + std::size_t(v.y)) * std::size_t(n.x) +
                       std::size_t(v.x)] = entry.second->material[i];
            }
        });
    }
    return labels;
}

} // namespace vs::field

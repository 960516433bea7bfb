// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/fine_texels.h"

#include <cstring>

namespace vs::sculpt {

void copyTexels(const Box3& from, const std::byte* source, const Box3& to, std::byte* target,
                std::size_t texelBytes) {
    const Box3 part = intersect(from, to);
    const auto at = [&](const Box3& box, int y, int z) {
        const glm::ivec3 size = box.size();
        return ((std::size_t(z - box.lo.z) * std::size_t(size.y) + std::size_t(y - box.lo.y)) *
                    std::size_t(size.x) +
                std::size_t(part.lo.x - box.lo.x)) *
               texelBytes;
    };
    for (int z = part.lo.z; z < part.hi.z; ++z) {
        for (int y = part.lo.y; y < part.hi.y; ++y) {
            std::memcpy(target + at(to, y, z), source + at(from, y, z),
                        std::size_t(part.size().x) * texelBytes);
        }
    }
}

namespace {

void fillTexels(const Box3& part, const Box3& box, std::byte* target, const std::vector<std::byte>& texel) {
    const glm::ivec3 size = box.size();
    for (int z = part.lo.z; z < part.hi.z; ++z) {
        for (int y = part.lo.y; y < part.hi.y; ++y) {
            std::byte* row =
                target + ((std::size_t(z - box.lo.z) * std::size_t(size.y) + std::size_t(y - box.lo.y)) *
                              std::size_t(size.x) +
                          std::size_t(part.lo.x - box.lo.x)) *
                             texel.size();
            for (int x = 0; x < part.size().x; ++x) {
                std::memcpy(row + std::size_t(x) * texel.size(), texel.data(), texel.size());
            }
        }
    }
}

} // namespace

std::vector<std::byte> texelsIn(const FineBricks& bricks, glm::ivec3 dims, std::size_t texelBytes,
                                const Box3& box) {
    std::vector<std::byte> all(box.volume() * texelBytes);
    const glm::ivec3 counts = divideUp(dims, kFineBrick);
    const Box3 part = intersect(box, {glm::ivec3(0), dims});
    if (part.isEmpty()) {
        return all;
    }
    const Box3 places{part.lo / kFineBrick, (part.hi - 1) / kFineBrick + 1};
    forEachVoxel(places, [&](glm::ivec3 brick, std::size_t) {
        const auto found = bricks.find((brick.z * counts.y + brick.y) * counts.x + brick.x);
        if (found == bricks.end()) {
            return;
        }
        const Box3 own{brick * kFineBrick, glm::min((brick + 1) * kFineBrick, dims)};
        const std::vector<std::byte>& texels = *found->second;
        if (texels.size() == texelBytes) {
            fillTexels(intersect(own, box), box, all.data(), texels);
        } else {
            copyTexels(own, texels.data(), box, all.data(), texelBytes);
        }
    });
    return all;
}

} // namespace vs::sculpt

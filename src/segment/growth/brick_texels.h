// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/texture.h"

#include <cstddef>
#include <vector>

namespace vs::segment {

// Texels of a box, read back from the device. Internal to this folder.
class BrickTexels {
public:
    BrickTexels() = default;
    BrickTexels(const gl::Texture& texture, const Box3& box)
        : box_(box), bytesPerTexel_(gl::bytesPerTexel(texture.format())), bytes_(texture.download(box)) {}

    [[nodiscard]] const std::byte* at(glm::ivec3 voxel) const {
        const glm::ivec3 size = box_.size();
        const glm::ivec3 in = voxel - box_.lo;
        return bytes_.data() +
               ((std::size_t(in.z) * std::size_t(size.y) + std::size_t(in.y)) * std::size_t(size.x) +
                std::size_t(in.x)) *
                   bytesPerTexel_;
    }

private:
    Box3 box_;
    std::size_t bytesPerTexel_ = 1;
    std::vector<std::byte> bytes_;
};

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#include "volume/grid/brick_source.h"

#include <cstring>

namespace vs::volume {

std::vector<std::byte> valuesIn(const Volume& volume, const Box3& box) {
    const std::size_t valueBytes = sizeOf(volume.type);
    const std::size_t row = std::size_t(box.size().x) * valueBytes;
    const glm::ivec3 dims = volume.geometry.dims;
    std::vector<std::byte> values(box.volume() * valueBytes);
    std::byte* to = values.data();
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y, to += row) {
            const std::size_t from =
                (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) +
                std::size_t(box.lo.x);
            std::memcpy(to, volume.bytes.data() + from * valueBytes, row);
        }
    }
    return values;
}

} // namespace vs::volume

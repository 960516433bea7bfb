// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace vs::gl {

// What volumes and what belongs to them take on the device: 3D textures and buffers, of all contexts.
// Pictures, which are 2D textures, are not counted.
struct DeviceBytes {
    std::size_t now = 0;
    std::size_t peak = 0; // the most that there were at any time
};
DeviceBytes deviceBytes();

// Internal to this folder.
enum class Counted : std::uint8_t { Texture, Buffer };
void countMade(Counted kind, unsigned int name, std::size_t bytes);
void countDeleted(Counted kind, unsigned int name);

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/host_fence.h"

#include "base/check.h"

#include <cstdint>
#include <cstring>

namespace vs::segment {

namespace {

template <typename T>
T valueOf(const std::byte* texel) {
    T value{};
    std::memcpy(&value, texel, sizeof(value));
    return value;
}

} // namespace

// Half and more of what the format can hold.
bool HostFence::isCut(const std::byte* texel) const {
    if (format_ == gl::Format::R8) {
        return valueOf<std::uint8_t>(texel) >= 0x80;
    }
    if (format_ == gl::Format::R16) {
        return valueOf<std::uint16_t>(texel) >= 0x8000;
    }
    if (format_ == gl::Format::R16F) { // positive halves are ordered as their bits are
        return valueOf<std::int16_t>(texel) >= 0x3800;
    }
    VS_CHECK(format_ == gl::Format::R32F);
    return valueOf<float>(texel) >= 0.5F;
}

} // namespace vs::segment

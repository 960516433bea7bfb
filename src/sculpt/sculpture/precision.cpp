// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/precision.h"

#include "base/check.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace vs::sculpt {

gl::Format formatOf(Precision precision) {
    switch (precision) {
    case Precision::Bits8:
        return gl::Format::R8;
    case Precision::Bits16:
        return gl::Format::R16F;
    case Precision::Bits32:
        break;
    }
    return gl::Format::R32F;
}

gl::Defines storedDefines(Precision precision) {
    return {{"SCULPTURE_BITS", kPrecisions[std::size_t(precision)]}};
}

float justVisible(Precision precision) {
    switch (precision) {
    case Precision::Bits8:
        return 127.0F / 255.0F;
    case Precision::Bits16:
        return 0.499755859375F;
    case Precision::Bits32:
        break;
    }
    return std::nextafter(0.5F, 0.0F);
}

std::vector<float> valuesOf(std::span<const std::byte> texels, Precision precision) {
    const std::size_t bytes = gl::bytesPerTexel(formatOf(precision));
    VS_CHECK_EQ(texels.size() % bytes, std::size_t(0));
    std::vector<float> values(texels.size() / bytes);
    if (precision == Precision::Bits32) {
        std::memcpy(values.data(), texels.data(), texels.size());
        return values;
    }
    for (std::size_t n = 0; n < values.size(); ++n) {
        std::uint16_t code = 0; // little-endian, as every device this runs on
        std::memcpy(&code, &texels[n * bytes], bytes);
        values[n] = precision == Precision::Bits8 ? float(code) / 255.0F : glm::unpackHalf1x16(code);
    }
    return values;
}

std::vector<std::byte> untouchedTexel(Precision precision) {
    return {gl::bytesPerTexel(formatOf(precision)), std::byte(0)};
}

std::vector<std::byte> texelsOf(std::span<const float> values, Precision precision) {
    const std::size_t bytes = gl::bytesPerTexel(formatOf(precision));
    std::vector<std::byte> texels(values.size() * bytes);
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (precision == Precision::Bits32) {
            std::memcpy(&texels[n * bytes], &values[n], bytes);
        } else {
            const auto code = precision == Precision::Bits8
                                  ? std::uint16_t(std::round(std::clamp(values[n], 0.0F, 1.0F) * 255.0F))
                                  : glm::packHalf1x16(values[n]);
            std::memcpy(&texels[n * bytes], &code, bytes);
        }
    }
    return texels;
}

void roundTo(Precision precision, std::span<float> values) {
    if (precision == Precision::Bits8) {
        for (float& value : values) {
            value = std::round(std::clamp(value, 0.0F, 1.0F) * 255.0F) / 255.0F;
        }
    } else if (precision == Precision::Bits16) {
        for (float& value : values) {
            value = glm::unpackHalf1x16(glm::packHalf1x16(value));
        }
    }
}

} // namespace vs::sculpt

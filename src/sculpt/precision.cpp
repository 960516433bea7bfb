// SPDX-License-Identifier: Apache-2.0
#include "sculpt/precision.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

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

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/texture.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vs::sculpt {

// How a sculpture's values, from 0 to 1, are stored: whole steps of 1/255, 16-bit floats, 32-bit floats.
enum class Precision { Bits8, Bits16, Bits32 };

gl::Format formatOf(Precision precision);
// The greatest value that can be stored and is still visible in cut view: the last one below 0.5.
float justVisible(Precision precision);
// What texels of a sculpture of this precision mean, one value each. The only place that knows.
std::vector<float> valuesOf(std::span<const std::byte> texels, Precision precision);

} // namespace vs::sculpt

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/shader_source.h"
#include "gl/texture.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace vs::sculpt {

// How radiation, from 0 to 1, is recorded (thesis, section 3.6.3): whole steps of 1/255, 16-bit floats,
// 32-bit floats.
enum class Precision { Bits8, Bits16, Bits32 };
// The names of precisions on command lines, in the order of the enumeration.
inline constexpr std::array<const char*, 3> kPrecisions{"8", "16", "32"};

gl::Format formatOf(Precision precision);
// The defines for shaders that include sculpt/shaders/stored_values.glsl.
gl::Defines storedDefines(Precision precision);
// The greatest value that can be stored and is still visible in cut view: the last one below 0.5.
float justVisible(Precision precision);
// What texels of a sculpture of this precision mean, one value each. The only place that knows.
std::vector<float> valuesOf(std::span<const std::byte> texels, Precision precision);
// A texel of a sculpture in which nothing is cut.
std::vector<std::byte> untouchedTexel(Precision precision);
// The texels of a sculpture of this precision that mean these values.
std::vector<std::byte> texelsOf(std::span<const float> values, Precision precision);

// Rounds radiation (0 and above) to what such a texture stores; 8-bit ones hold 0 to 1. The thesis
// (section 3.6.3) blended splat by splat into the texture itself, so 8 bits also lost every contribution
// below half a grey level. Here energies are added in 32-bit fixed point, and only the recorded result is
// rounded.
void roundTo(Precision precision, std::span<float> values);

} // namespace vs::sculpt

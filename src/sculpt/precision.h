// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

namespace vs::sculpt {

// What the texture that records a radiation volume holds a value in (thesis 3.6.3): 8-bit unsigned
// normalised, 16-bit or 32-bit floating point.
enum class Precision { Bits8, Bits16, Bits32 };
// Their names on command lines, in the order of the enumeration.
inline constexpr std::array<const char*, 3> kPrecisions{"8", "16", "32"};

// Rounds radiation (0 and above) to what such a texture stores; 8-bit ones hold 0 to 1. The thesis blended
// splat by splat into the texture itself, so 8 bits also lost every contribution below half a grey level.
// Here energies are added in 32-bit fixed point, and only the recorded result is rounded.
void roundTo(Precision precision, std::span<float> values);

} // namespace vs::sculpt

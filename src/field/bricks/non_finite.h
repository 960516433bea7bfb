// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::field {

// Stands for NaN and infinity: far below any value, small enough that interpolation stays finite.
inline constexpr float kNonFinite = -1e30F;

} // namespace vs::field

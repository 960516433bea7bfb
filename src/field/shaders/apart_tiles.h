// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::field {

// The layout of tiles of one segment alone, which shaders include too.
#include "field/shaders/apart_tiles.glsl"

} // namespace vs::field

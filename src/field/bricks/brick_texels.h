// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/texture.h"
#include "volume/grid/volume.h"

namespace vs::field {

// How values of a type become texels of bricks: value = texel * scale + offset, as field::Field has them.
struct BrickTexels {
    gl::Format format = gl::Format::R8;
    float valueScale = 1;
    float valueOffset = 0;
};
BrickTexels brickTexels(volume::ScalarType type);

} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/brick_texels.h"

namespace vs::field {

BrickTexels brickTexels(volume::ScalarType type) {
    switch (type) {
    case volume::ScalarType::UInt8:
        return {gl::Format::R8, 255, 0};
    case volume::ScalarType::Int8:
        return {gl::Format::R8, 255, -128};
    case volume::ScalarType::UInt16:
        return {gl::Format::R16, 65535, 0};
    case volume::ScalarType::Int16:
        return {gl::Format::R16, 65535, -32768};
    case volume::ScalarType::UInt32:
    case volume::ScalarType::Int32:
    case volume::ScalarType::Float32:
        break;
    }
    return {gl::Format::R32F, 1, 0};
}

} // namespace vs::field

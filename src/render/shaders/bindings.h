// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::render {

// The numbers of the bindings of this module's programs, which its shaders include too.
#include "render/shaders/bindings.glsl"

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::gl {

// The numbers of the bindings of this module's programs, which its shaders include too.
#include "gl/shaders/bindings.glsl"

} // namespace vs::gl

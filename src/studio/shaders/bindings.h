// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::studio {

// The numbers of the bindings of this module's programs, which its shaders include too.
#include "studio/shaders/bindings.glsl"

} // namespace vs::studio

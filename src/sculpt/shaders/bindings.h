// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::sculpt {

// The numbers of the bindings of this module's programs, which its shaders include too.
#include "sculpt/shaders/bindings.glsl"

} // namespace vs::sculpt

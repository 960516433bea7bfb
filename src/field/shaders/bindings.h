// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::field {

// The numbers of the bindings of this module's programs, which its shaders include too.
#include "field/shaders/bindings.glsl"

} // namespace vs::field

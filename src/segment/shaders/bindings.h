// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vs::segment {

// The numbers of the bindings of this module's programs, which its shaders include too.
#include "segment/shaders/bindings.glsl"

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/embedded_text.h"

#include <span>

namespace vs::render {

// The files of data/transfer_functions, in alphabetical order (generated at build).
std::span<const EmbeddedText> embeddedPresets();

} // namespace vs::render

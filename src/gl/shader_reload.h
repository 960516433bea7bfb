// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

// Shaders that somebody edits while the program runs (doc/contributing.md): what it shows follows without a
// restart.
namespace vs::gl {

// From now on each program compiles its shader anew before it is used next. One that no longer compiles stays
// as it was, and is tried again after the next call.
void reloadShaders();

// How often reloadShaders() has been called.
[[nodiscard]] int shaderGeneration();

// A program could not be compiled anew: logs why, and keeps it for takeShaderFault().
void tellShaderFault(const std::string& fault);

// The first fault that nobody has taken yet, as the compiler put it; forgets it and those after it.
[[nodiscard]] std::optional<std::string> takeShaderFault();

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace vs::gl {

// One shader file, compiled into the program. `path` is its path below src/: "render/shaders/cast_rays.comp".
struct EmbeddedShader {
    std::string_view path;
    std::string_view source;
};

// Every shader file of every module (generated at build).
std::span<const EmbeddedShader> embeddedShaders();

} // namespace vs::gl

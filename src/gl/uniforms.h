// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

// The uniforms of a program. Internal to this folder; others set them by their names: Program::set().
namespace vs::gl {

struct Uniform {
    int location = -1; // below 0: declared, but this variant does not use it
    unsigned int type = 0;
    int count = 1; // of elements, if it is an array
};
using Uniforms = std::map<std::string, Uniform, std::less<>>;

// The uniforms that the source of a program declares, and where the driver put those that it kept.
Uniforms readUniforms(unsigned int program, std::string_view source);

// Gives the uniforms of `to` the values that those of the same name and type have in `from`. Samplers and
// images keep the units that their shader gives them.
void copyUniforms(unsigned int from, const Uniforms& ofFrom, unsigned int to, const Uniforms& ofTo);

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/buffer.h"
#include "gl/handle.h"
#include "gl/shader_source.h"

#include <map>
#include <string>

namespace vs::gl {

namespace detail {
void deleteProgram(unsigned int name);
}

// What a dispatch's results are used for next; stands beside the dispatch that needs it.
enum class Barrier { None, Image, Texture, Storage, Indirect, All };

// One compute shader, ready to run. Uniforms have explicit locations in the shader.
class Program {
public:
    Program() = default;
    // `path` below src/, for example "sculpt/shaders/deposit_points.comp". Throws GlError with the driver's
    // log, places given as file:line.
    explicit Program(const std::string& path, const Defines& defines = {});

    [[nodiscard]] unsigned int name() const { return handle_.name(); }
    explicit operator bool() const { return bool(handle_); }

    Program& set(int location, int value);
    Program& set(int location, unsigned int value);
    Program& set(int location, float value);
    Program& set(int location, glm::vec2 value);
    Program& set(int location, glm::vec3 value);
    Program& set(int location, glm::vec4 value);
    Program& set(int location, glm::ivec2 value);
    Program& set(int location, glm::ivec3 value);
    Program& set(int location, const glm::mat4& value);

    // Runs the given number of work groups; nothing if one of them is 0. `after` makes the writes visible to
    // what follows.
    void dispatch(glm::ivec3 groups, Barrier after);
    // Enough groups of the shader's own local size to cover `items`.
    void dispatchOver(glm::ivec3 items, Barrier after);
    // The same for a list of any length, for shaders with a local size along x only that take their item from
    // gl/shaders/items.glsl: OpenGL promises no more than 65535 groups along an axis, and one row of them is
    // soon used up.
    void dispatchOverList(std::size_t items, Barrier after);
    // Group counts are three unsigned ints in `arguments` at `offset` bytes.
    void dispatchIndirect(const Buffer& arguments, std::size_t offset, Barrier after);

private:
    Handle<detail::deleteProgram> handle_;
    glm::ivec3 localSize_{1};
};

// One shader compiled for each set of defines when that is first needed.
class ProgramVariants {
public:
    explicit ProgramVariants(std::string path) : path_(std::move(path)) {}
    Program& with(const Defines& defines);

private:
    std::string path_;
    std::map<Defines, Program> variants_;
};

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/buffer.h"
#include "gl/dispatch_pace.h"
#include "gl/handle.h"
#include "gl/sampler_slots.h"
#include "gl/shader_source.h"
#include "gl/uniforms.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vs::gl {

struct ProgramAccess;

namespace detail {
void deleteProgram(unsigned int name);
}

// Groups along one axis of a dispatch: OpenGL promises no more.
inline constexpr std::uint32_t kMaxGroups = 65535;

// What a dispatch's results are used for next; stands beside the dispatch that needs it.
enum class Barrier { None, Image, Texture, Storage, Indirect, All };

// One compute shader, ready to run. The shader declares its uniforms; here they are set by their names.
// Compiles anew, with the values that its uniforms have, when it is used after reloadShaders().
class Program {
public:
    Program() = default;
    // `path` below src/, for example "sculpt/shaders/deposit_points.comp". Throws GlError with the driver's
    // log, places given as file:line.
    explicit Program(const std::string& path, const Defines& defines = {});

    [[nodiscard]] unsigned int name() const { return handle_.name(); }
    explicit operator bool() const { return bool(handle_); }

    // Sets a uniform. Does nothing for one that the shader declares and this variant of it does not use.
    // Throws GlError for a name that the shader does not have, and for a value of another type than the
    // uniform's.
    Program& set(std::string_view uniform, int value);
    Program& set(std::string_view uniform, unsigned int value);
    Program& set(std::string_view uniform, float value);
    Program& set(std::string_view uniform, glm::vec2 value);
    Program& set(std::string_view uniform, glm::vec3 value);
    Program& set(std::string_view uniform, glm::vec4 value);
    Program& set(std::string_view uniform, glm::ivec2 value);
    Program& set(std::string_view uniform, glm::ivec3 value);
    Program& set(std::string_view uniform, const glm::mat4& value);
    // Sets the first elements of an array.
    Program& set(std::string_view uniform, std::span<const float> values);
    Program& set(std::string_view uniform, std::span<const glm::vec4> values);

    // Runs the given number of work groups; nothing if one of them is 0. `after` makes the writes visible to
    // what follows.
    void dispatch(glm::ivec3 groups, Barrier after);
    // Runs enough groups of the shader's own local size to cover `items`. Where the shader takes its place
    // from gl/shaders/place.glsl, what may take long is submitted in several layers along z, and waited for.
    void dispatchOver(glm::ivec3 items, Barrier after);
    // Runs enough groups to cover a list of any length, for shaders with a local size along x only that take
    // their item from gl/shaders/items.glsl: one row of kMaxGroups groups is soon used up.
    void dispatchOverList(std::size_t items, Barrier after);
    // Runs as many groups as three unsigned ints in `arguments` say, at `offset` bytes.
    void dispatchIndirect(const Buffer& arguments, std::size_t offset, Barrier after);

private:
    struct Place {
        unsigned int program = 0;
        int location = -1; // below 0 for one that this variant does not use: OpenGL ignores what is set there
    };
    [[nodiscard]] Place find(std::string_view uniform, unsigned int type);
    void use();
    void reload();
    void tellHazards(unsigned int arguments);
    void submitLayers(glm::ivec3 groups, Barrier after);

    Handle<detail::deleteProgram> handle_;
    std::string path_;
    Defines defines_;
    int generation_ = 0; // of shaders
    Uniforms uniforms_;
    Samplers samplers_;
    glm::ivec3 localSize_{1};
    std::optional<DispatchPace> pace_; // of a shader whose work can be submitted in layers
    std::shared_ptr<const std::vector<ProgramAccess>> accesses_; // while hazards are watched
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

// SPDX-License-Identifier: Apache-2.0
#include "gl/program.h"

#include "base/error.h"
#include "base/timer.h"
#include "gl/hazard_watch.h"
#include "gl/kept_programs.h"
#include "gl/limits.h"
#include "gl/shader_reload.h"

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>

#include <utility>

namespace vs::gl {

static_assert(std::is_nothrow_move_constructible_v<Program>);

namespace detail {
void deleteProgram(unsigned int name) {
    glDeleteProgram(name);
    forgetInSamplerSlots(name);
}
} // namespace detail

namespace {

constexpr std::string_view kFirstPlace = "firstPlace"; // gl/shaders/place.glsl

std::string programLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return log.c_str();
}

Handle<detail::deleteProgram> compiled(const std::string& path, const ExpandedSource& source) {
    const char* text = source.text.c_str();
    Handle<detail::deleteProgram> program(glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text));
    GLint isLinked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &isLinked);
    if (isLinked != GL_TRUE) {
        throw GlError("{} does not compile on this driver: {}", path,
                      readableLog(programLog(program.name()), source));
    }
    return program;
}

Handle<detail::deleteProgram> made(const std::string& path, const ExpandedSource& source) {
    if (const GLuint kept = loadKeptProgram(source.text)) {
        return Handle<detail::deleteProgram>(kept);
    }
    auto fresh = compiled(path, source);
    keepProgram(fresh.name(), source.text);
    return fresh;
}

void addBarrier(Barrier after) {
    switch (after) {
    case Barrier::None:
        return;
    case Barrier::Image:
        return memoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    case Barrier::Texture:
        return memoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    case Barrier::Storage:
        return memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    case Barrier::Indirect:
        return memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    case Barrier::All:
        return memoryBarrier(GL_ALL_BARRIER_BITS);
    }
}

Defines withPretended(Defines defines) {
    if (const int steps = pretendedFilterSteps(); steps > 0) {
        defines.emplace_back("FILTER_STEPS", std::to_string(steps));
    }
    return defines;
}

} // namespace

Program::Program(const std::string& path, const Defines& defines)
    : path_(path), defines_(defines), generation_(shaderGeneration()) {
    const ExpandedSource source = expandSource(path, withPretended(defines));
    handle_ = made(path, source);
    const GLuint program = name();
    glObjectLabel(GL_PROGRAM, program, -1, path.c_str());
    glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, glm::value_ptr(localSize_));
    uniforms_ = readUniforms(program, source.text);
    samplers_ = samplersOf(uniforms_);
    accesses_ = accessesIfWatched(program, source.text);
}

// Comes before everything that the program is used for.
void Program::use() {
    if (generation_ != shaderGeneration() && handle_) {
        reload();
    }
}

void Program::reload() {
    generation_ = shaderGeneration();
    try {
        Program fresh(path_, defines_);
        fresh.pace_ = pace_;
        copyUniforms(name(), uniforms_, fresh.name(), fresh.uniforms_);
        *this = std::move(fresh);
    } catch (const GlError& error) {
        tellShaderFault(error.what());
    }
}

// What the next dispatch accesses, for whoever watches; `arguments` is the buffer of an indirect one, or 0.
void Program::tellHazards(unsigned int arguments) {
    if (hazards() == nullptr) {
        return;
    }
    if (!accesses_) { // hazards were not watched yet when the program was made
        accesses_ = accessesIfWatched(name(), expandSource(path_, withPretended(defines_)).text);
    }
    noteDispatch(path_, *accesses_, arguments);
}

Program::Place Program::find(std::string_view uniform, unsigned int type) {
    use();
    const auto found = uniforms_.find(uniform);
    if (found == uniforms_.end()) {
        throw GlError("{} has no uniform '{}'", path_, uniform);
    }
    const Uniform& it = found->second;
    if (it.location >= 0 && it.type != type) {
        throw GlError("{}: the uniform '{}' has another type", path_, uniform);
    }
    return {name(), it.location};
}

Program& Program::set(std::string_view uniform, int value) {
    const auto [program, location] = find(uniform, GL_INT);
    glProgramUniform1i(program, location, value);
    return *this;
}
Program& Program::set(std::string_view uniform, unsigned int value) {
    const auto [program, location] = find(uniform, GL_UNSIGNED_INT);
    glProgramUniform1ui(program, location, value);
    return *this;
}
Program& Program::set(std::string_view uniform, float value) {
    const auto [program, location] = find(uniform, GL_FLOAT);
    glProgramUniform1f(program, location, value);
    return *this;
}
Program& Program::set(std::string_view uniform, glm::vec2 value) {
    const auto [program, location] = find(uniform, GL_FLOAT_VEC2);
    glProgramUniform2fv(program, location, 1, glm::value_ptr(value));
    return *this;
}
Program& Program::set(std::string_view uniform, glm::vec3 value) {
    const auto [program, location] = find(uniform, GL_FLOAT_VEC3);
    glProgramUniform3fv(program, location, 1, glm::value_ptr(value));
    return *this;
}
Program& Program::set(std::string_view uniform, glm::vec4 value) {
    const auto [program, location] = find(uniform, GL_FLOAT_VEC4);
    glProgramUniform4fv(program, location, 1, glm::value_ptr(value));
    return *this;
}
Program& Program::set(std::string_view uniform, glm::ivec2 value) {
    const auto [program, location] = find(uniform, GL_INT_VEC2);
    glProgramUniform2iv(program, location, 1, glm::value_ptr(value));
    return *this;
}
Program& Program::set(std::string_view uniform, glm::ivec3 value) {
    const auto [program, location] = find(uniform, GL_INT_VEC3);
    glProgramUniform3iv(program, location, 1, glm::value_ptr(value));
    return *this;
}
Program& Program::set(std::string_view uniform, const glm::mat4& value) {
    const auto [program, location] = find(uniform, GL_FLOAT_MAT4);
    glProgramUniformMatrix4fv(program, location, 1, GL_FALSE, glm::value_ptr(value));
    return *this;
}
Program& Program::set(std::string_view uniform, std::span<const float> values) {
    const auto [program, location] = find(uniform, GL_FLOAT);
    glProgramUniform1fv(program, location, GLsizei(values.size()), values.data());
    return *this;
}
Program& Program::set(std::string_view uniform, std::span<const glm::vec4> values) {
    if (!values.empty()) {
        const auto [program, location] = find(uniform, GL_FLOAT_VEC4);
        glProgramUniform4fv(program, location, GLsizei(values.size()), glm::value_ptr(values.front()));
    }
    return *this;
}

void Program::dispatch(glm::ivec3 groups, Barrier after) {
    if (groups.x > 0 && groups.y > 0 && groups.z > 0) {
        use();
        tellHazards(0);
        settleSamplerSlots(name(), samplers_);
        glUseProgram(name());
        glDispatchCompute(GLuint(groups.x), GLuint(groups.y), GLuint(groups.z));
        addBarrier(after);
    }
}

void Program::dispatchOver(glm::ivec3 items, Barrier after) {
    use(); // the local size may be another one
    const glm::ivec3 groups = (items + localSize_ - 1) / localSize_;
    if (!uniforms_.contains(kFirstPlace)) {
        dispatch(groups, after);
    } else if (groups.x > 0 && groups.y > 0 && groups.z > 0) {
        submitLayers(groups, after);
    }
}

// Waits for nothing where all may go at once.
void Program::submitLayers(glm::ivec3 groups, Barrier after) {
    if (!pace_) {
        pace_.emplace(longestDispatchMs());
    }
    const glm::ivec3 all = groups * localSize_;
    const std::size_t perLayer = std::size_t(all.x) * std::size_t(all.y) * std::size_t(localSize_.z);
    for (int z = 0; z < groups.z;) {
        const int layers = pace_->layers(groups.z - z, perLayer);
        if (z == 0 && layers < groups.z) {
            glFinish(); // or it would be charged for what was submitted before
        }
        set(kFirstPlace, glm::ivec3(0, 0, z * localSize_.z));
        const Timer timer;
        dispatch({groups.x, groups.y, layers}, after);
        if (layers < groups.z) {
            glFinish();
            pace_->note(std::size_t(layers) * perLayer, timer.milliseconds());
        }
        z += layers;
    }
    set(kFirstPlace, glm::ivec3(0)); // whatever runs it next
}

void Program::dispatchOverList(std::size_t items, Barrier after) {
    use();
    const std::size_t groups = (items + std::size_t(localSize_.x) - 1) / std::size_t(localSize_.x);
    const std::size_t rows = (groups + kMaxGroups - 1) / kMaxGroups;
    if (groups > 0) {
        VS_CHECK(rows <= kMaxGroups);
        dispatch({int((groups + rows - 1) / rows), int(rows), 1}, after);
    }
}

void Program::dispatchIndirect(const Buffer& arguments, std::size_t offset, Barrier after) {
    use();
    tellHazards(arguments.name());
    settleSamplerSlots(name(), samplers_);
    glUseProgram(name());
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments.name());
    glDispatchComputeIndirect(GLintptr(offset));
    addBarrier(after);
}

Program& ProgramVariants::with(const Defines& defines) {
    Program& program = variants_[defines];
    if (!program) {
        program = Program(path_, defines);
    }
    return program;
}

} // namespace vs::gl

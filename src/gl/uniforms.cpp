// SPDX-License-Identifier: Apache-2.0
#include "gl/uniforms.h"

#include "gl/shader_source.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace vs::gl {

Uniforms readUniforms(unsigned int program, std::string_view source) {
    Uniforms uniforms;
    for (const std::string& declared : declaredUniforms(source)) {
        uniforms.emplace(declared, Uniform{});
    }
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLuint n = 0; n < GLuint(count); ++n) {
        std::array<char, 256> text{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, n, GLsizei(text.size()), nullptr, &size, &type, text.data());
        const std::string_view found(text.data());
        const auto bracket = found.find('['); // of an array: its first element
        uniforms[std::string(found.substr(0, bracket))] = {glGetUniformLocation(program, text.data()), type,
                                                           size};
    }
    return uniforms;
}

namespace {

// One value, of the types that Program::set() has.
void copyValue(GLenum type, GLuint from, GLint source, GLuint to, GLint target) {
    std::array<GLfloat, 16> floats{};
    std::array<GLint, 4> ints{};
    std::array<GLuint, 4> unsignedInts{};
    if (type == GL_INT || type == GL_INT_VEC2 || type == GL_INT_VEC3) {
        glGetUniformiv(from, source, ints.data());
    } else if (type == GL_UNSIGNED_INT) {
        glGetUniformuiv(from, source, unsignedInts.data());
    } else {
        glGetUniformfv(from, source, floats.data());
    }
    switch (type) {
    case GL_INT:
        return glProgramUniform1iv(to, target, 1, ints.data());
    case GL_INT_VEC2:
        return glProgramUniform2iv(to, target, 1, ints.data());
    case GL_INT_VEC3:
        return glProgramUniform3iv(to, target, 1, ints.data());
    case GL_UNSIGNED_INT:
        return glProgramUniform1uiv(to, target, 1, unsignedInts.data());
    case GL_FLOAT:
        return glProgramUniform1fv(to, target, 1, floats.data());
    case GL_FLOAT_VEC2:
        return glProgramUniform2fv(to, target, 1, floats.data());
    case GL_FLOAT_VEC3:
        return glProgramUniform3fv(to, target, 1, floats.data());
    case GL_FLOAT_VEC4:
        return glProgramUniform4fv(to, target, 1, floats.data());
    case GL_FLOAT_MAT4:
        return glProgramUniformMatrix4fv(to, target, 1, GL_FALSE, floats.data());
    default:
        return;
    }
}

GLint locationOf(GLuint program, const std::string& name, int element) {
    return glGetUniformLocation(program, (name + "[" + std::to_string(element) + "]").c_str());
}

} // namespace

void copyUniforms(unsigned int from, const Uniforms& ofFrom, unsigned int to, const Uniforms& ofTo) {
    for (const auto& [name, target] : ofTo) {
        const auto found = ofFrom.find(name);
        if (found == ofFrom.end() || found->second.location < 0 || target.location < 0 ||
            found->second.type != target.type) {
            continue;
        }
        copyValue(target.type, from, found->second.location, to, target.location);
        for (int n = 1; n < std::min(found->second.count, target.count); ++n) {
            copyValue(target.type, from, locationOf(from, name, n), to, locationOf(to, name, n));
        }
    }
}

} // namespace vs::gl

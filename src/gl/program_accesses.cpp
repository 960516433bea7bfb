// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gl/hazard_watch.h"
#include "gl/shader_accesses.h"

#include <epoxy/gl.h>

#include <array>
#include <optional>

namespace vs::gl {

namespace {

std::string resourceName(GLuint program, GLenum interface, GLuint index) {
    std::array<char, 256> text{};
    glGetProgramResourceName(program, interface, index, GLsizei(text.size()), nullptr, text.data());
    const std::string name(text.data());
    return name.substr(0, name.find('[')); // an array is called after its first element
}

GLint propertyOf(GLuint program, GLenum interface, GLuint index, GLenum property) {
    GLint value = 0;
    glGetProgramResourceiv(program, interface, index, 1, &property, 1, nullptr, &value);
    return value;
}

GLuint countOf(GLuint program, GLenum interface) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return GLuint(count);
}

// The unit's access by a uniform of this type; nothing for one that is neither sampler nor image.
std::optional<ProgramAccess> accessOfType(GLenum type) {
    switch (type) {
    case GL_SAMPLER_2D:
    case GL_INT_SAMPLER_2D:
    case GL_UNSIGNED_INT_SAMPLER_2D:
        return ProgramAccess{Use::Fetch, 0, GL_TEXTURE_BINDING_2D};
    case GL_SAMPLER_3D:
    case GL_INT_SAMPLER_3D:
    case GL_UNSIGNED_INT_SAMPLER_3D:
        return ProgramAccess{Use::Fetch, 0, GL_TEXTURE_BINDING_3D};
    case GL_SAMPLER_BUFFER:
    case GL_INT_SAMPLER_BUFFER:
    case GL_UNSIGNED_INT_SAMPLER_BUFFER:
        return ProgramAccess{Use::Fetch, 0, GL_TEXTURE_BINDING_BUFFER, true};
    case GL_IMAGE_2D:
    case GL_INT_IMAGE_2D:
    case GL_UNSIGNED_INT_IMAGE_2D:
    case GL_IMAGE_3D:
    case GL_INT_IMAGE_3D:
    case GL_UNSIGNED_INT_IMAGE_3D:
        return ProgramAccess{Use::Image, 0, GL_IMAGE_BINDING_NAME};
    case GL_IMAGE_BUFFER:
    case GL_INT_IMAGE_BUFFER:
    case GL_UNSIGNED_INT_IMAGE_BUFFER:
        return ProgramAccess{Use::Image, 0, GL_IMAGE_BINDING_NAME, true};
    default:
        return std::nullopt;
    }
}

bool isNumber(GLenum type) {
    switch (type) {
    case GL_FLOAT:
    case GL_FLOAT_VEC2:
    case GL_FLOAT_VEC3:
    case GL_FLOAT_VEC4:
    case GL_FLOAT_MAT3:
    case GL_FLOAT_MAT4:
    case GL_INT:
    case GL_INT_VEC2:
    case GL_INT_VEC3:
    case GL_INT_VEC4:
    case GL_UNSIGNED_INT:
    case GL_UNSIGNED_INT_VEC2:
    case GL_UNSIGNED_INT_VEC3:
    case GL_UNSIGNED_INT_VEC4:
    case GL_BOOL:
        return true;
    default:
        return false;
    }
}

using Declared = std::map<std::string, DeclaredAccess, std::less<>>;

void addUniforms(GLuint program, const Declared& declared, ProgramAccesses& out) {
    for (GLuint n = 0; n < countOf(program, GL_UNIFORM); ++n) {
        const auto type = GLenum(propertyOf(program, GL_UNIFORM, n, GL_TYPE));
        const std::string name = resourceName(program, GL_UNIFORM, n);
        auto access = accessOfType(type);
        const GLint location = propertyOf(program, GL_UNIFORM, n, GL_LOCATION);
        if (!access) {
            if (!isNumber(type) && type != GL_UNSIGNED_INT_ATOMIC_COUNTER) {
                throw GlError("uniform '{}' is of the type 0x{:04x}, whose accesses are not known; add it to "
                              "gl/program_accesses.cpp",
                              name, type);
            }
            continue;
        }
        const auto found = declared.find(name);
        access->writes = access->use == Use::Image && (found == declared.end() || found->second.writes);
        access->reads = found == declared.end() || found->second.reads;
        for (GLint i = 0; i < propertyOf(program, GL_UNIFORM, n, GL_ARRAY_SIZE); ++i) {
            GLint unit = 0;
            glGetUniformiv(program, location + i, &unit);
            access->unit = GLuint(unit);
            out.push_back(*access);
        }
    }
}

void addBlocks(GLuint program, GLenum interface, ProgramAccess access, const Declared& declared,
               ProgramAccesses& out) {
    for (GLuint n = 0; n < countOf(program, interface); ++n) {
        const auto found = declared.find(resourceName(program, interface, n));
        if (found != declared.end() && !found->second.isUsed) {
            continue; // OpenGL counts all std140 and std430 blocks as used
        }
        access.unit = GLuint(propertyOf(program, interface, n, GL_BUFFER_BINDING));
        access.reads = found == declared.end() || found->second.reads;
        access.writes = access.use == Use::Storage && (found == declared.end() || found->second.writes);
        out.push_back(access);
    }
}

} // namespace

ProgramAccesses readAccesses(unsigned int program, std::string_view source) {
    const Declared declared = declaredAccesses(source);
    ProgramAccesses out;
    addUniforms(program, declared, out);
    addBlocks(program, GL_SHADER_STORAGE_BLOCK, {Use::Storage, 0, GL_SHADER_STORAGE_BUFFER_BINDING}, declared,
              out);
    addBlocks(program, GL_UNIFORM_BLOCK, {Use::Uniform, 0, GL_UNIFORM_BUFFER_BINDING}, declared, out);
    for (GLuint n = 0; n < countOf(program, GL_ATOMIC_COUNTER_BUFFER); ++n) {
        const GLint binding = propertyOf(program, GL_ATOMIC_COUNTER_BUFFER, n, GL_BUFFER_BINDING);
        out.push_back({Use::Counter, GLuint(binding), GL_ATOMIC_COUNTER_BUFFER_BINDING, false, true, true});
    }
    return out;
}

} // namespace vs::gl

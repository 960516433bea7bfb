// SPDX-License-Identifier: Apache-2.0
#include "gl/embedded_shaders.h"
#include "gl/program.h"
#include "gl/shader_accesses.h"
#include "gpu/gl/variants.h"
#include "gpu/gl_test.h"

#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <map>

namespace vs::gl {
namespace {

using MinimaTest = test::GlTest;

// What every device has at least (OpenGL 4.5 core, tables 23.56 to 23.69).
constexpr std::array<int, 3> kWorkGroupSize{1024, 1024, 64};
const std::map<std::string, int> kMinima{
    {"invocations of a work group", 1024},
    {"bytes of shared memory", 32768},
    {"storage blocks", 8},
    {"storage bindings", 8},
    {"images", 8},
    {"image units", 8},
    {"images and storage blocks together", 8},
    {"textures", 16},
    {"texture units", 80},
    {"uniform blocks", 14},
    {"uniform bindings", 84},
    {"bytes of a uniform block", 16384},
    {"components of uniforms", 1024},
};

using Needs = std::map<std::string, int>;

GLint propertyOf(const Program& program, GLenum interface, GLuint index, GLenum property) {
    GLint value = 0;
    glGetProgramResourceiv(program.name(), interface, index, 1, &property, 1, nullptr, &value);
    return value;
}

GLuint countOf(const Program& program, GLenum interface) {
    GLint count = 0;
    glGetProgramInterfaceiv(program.name(), interface, GL_ACTIVE_RESOURCES, &count);
    return GLuint(count);
}

// How many components a uniform of a type has; 0 for images, -1 for samplers.
int componentsOf(GLenum type) {
    switch (type) {
    case GL_FLOAT:
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_BOOL:
        return 1;
    case GL_FLOAT_VEC2:
    case GL_INT_VEC2:
        return 2;
    case GL_FLOAT_VEC3:
    case GL_INT_VEC3:
        return 3;
    case GL_FLOAT_VEC4:
    case GL_INT_VEC4:
    case GL_UNSIGNED_INT_VEC4:
        return 4;
    case GL_FLOAT_MAT3:
        return 9;
    case GL_FLOAT_MAT4:
        return 16;
    case GL_IMAGE_2D:
    case GL_IMAGE_3D:
    case GL_IMAGE_BUFFER:
    case GL_UNSIGNED_INT_IMAGE_2D:
    case GL_UNSIGNED_INT_IMAGE_3D:
    case GL_UNSIGNED_INT_IMAGE_BUFFER:
        return 0;
    case GL_SAMPLER_2D:
    case GL_SAMPLER_3D:
    case GL_SAMPLER_BUFFER:
    case GL_UNSIGNED_INT_SAMPLER_2D:
    case GL_UNSIGNED_INT_SAMPLER_3D:
    case GL_UNSIGNED_INT_SAMPLER_BUFFER:
        return -1;
    default:
        ADD_FAILURE() << "uniforms of the type " << type << " are not known here";
        return 0;
    }
}

void addBlocks(const Program& program, GLenum interface, const std::string& blocks,
               const std::string& bindings, Needs& out) {
    for (GLuint n = 0; n < countOf(program, interface); ++n) {
        ++out[blocks];
        out[bindings] = std::max(out[bindings], propertyOf(program, interface, n, GL_BUFFER_BINDING) + 1);
        if (interface == GL_UNIFORM_BLOCK) {
            int& bytes = out["bytes of a uniform block"];
            bytes = std::max(bytes, propertyOf(program, interface, n, GL_BUFFER_DATA_SIZE));
        }
    }
}

void addUniforms(const Program& program, Needs& out) {
    for (GLuint n = 0; n < countOf(program, GL_UNIFORM); ++n) {
        if (propertyOf(program, GL_UNIFORM, n, GL_BLOCK_INDEX) >= 0) {
            continue;
        }
        const int components = componentsOf(GLenum(propertyOf(program, GL_UNIFORM, n, GL_TYPE)));
        const int count = propertyOf(program, GL_UNIFORM, n, GL_ARRAY_SIZE);
        out["components of uniforms"] += std::max(components, 0) * count;
        if (components <= 0) {
            GLint unit = 0;
            glGetUniformiv(program.name(), propertyOf(program, GL_UNIFORM, n, GL_LOCATION), &unit);
            out[components == 0 ? "images" : "textures"] += count;
            int& units = out[components == 0 ? "image units" : "texture units"];
            units = std::max(units, unit + count);
        }
    }
}

Needs needsOf(const Program& program, const std::string& source) {
    Needs out;
    addUniforms(program, out);
    addBlocks(program, GL_SHADER_STORAGE_BLOCK, "storage blocks", "storage bindings", out);
    addBlocks(program, GL_UNIFORM_BLOCK, "uniform blocks", "uniform bindings", out);
    out["images and storage blocks together"] = out["images"] + out["storage blocks"];
    out["bytes of shared memory"] = int(sharedBytes(source));
    std::array<int, 3> size{};
    glGetProgramiv(program.name(), GL_COMPUTE_WORK_GROUP_SIZE, size.data());
    out["invocations of a work group"] = size[0] * size[1] * size[2];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_LE(size.at(axis), kWorkGroupSize.at(axis)) << "work group along axis " << axis;
    }
    return out;
}

// What a program needs beyond the minima, one line each.
std::vector<std::string> beyond(const Needs& needs) {
    std::vector<std::string> out;
    for (const auto& [what, count] : needs) {
        if (count > kMinima.at(what)) {
            out.push_back(fmt::format("{} {}, and {} are guaranteed", count, what, kMinima.at(what)));
        }
    }
    return out;
}

TEST_F(MinimaTest, EveryVariantOfEveryShaderRunsOnEveryDevice) {
    int variants = 0;
    for (const EmbeddedShader& shader : embeddedShaders()) {
        const std::string path(shader.path);
        if (!path.ends_with(".comp")) {
            continue;
        }
        for (const Defines& defines : test::variantsOf(findShader(path).value())) {
            const Needs needs = needsOf(Program(path, defines), expandSource(path, defines).text);
            EXPECT_EQ(beyond(needs), std::vector<std::string>()) << test::textOf(path, defines);
            ++variants;
        }
    }
    EXPECT_GT(variants, 100);
}

TEST_F(MinimaTest, WhatNeedsMoreIsNamed) {
    int units = 0;
    glGetIntegerv(GL_MAX_IMAGE_UNITS, &units);
    if (units <= 8) {
        GTEST_SKIP()
            << "this device has no more than what is guaranteed, and compiles nothing that needs more";
    }
    setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
    const Needs needs = needsOf(Program("need_much.comp"), expandSource("need_much.comp", {}).text);
    unsetenv("VOLUME_STUDIO_SHADER_DIR");
    EXPECT_EQ(beyond(needs),
              (std::vector<std::string>{"9 image units, and 8 are guaranteed",
                                        "9 images and storage blocks together, and 8 are guaranteed",
                                        "9 storage bindings, and 8 are guaranteed"}));
}

} // namespace
} // namespace vs::gl

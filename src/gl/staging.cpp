// SPDX-License-Identifier: Apache-2.0
#include "gl/staging.h"

#include "base/check.h"
#include "base/error.h"
#include "gl/context.h"
#include "gl/errors.h"
#include "gl/handle.h"
#include "gl/program.h"
#include "gl/shader_source.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace vs::gl {

namespace {

constexpr std::size_t kMostAtOnce = std::size_t(64) << 20;

void deleteStage(unsigned int name) { glDeleteBuffers(1, &name); }

using Stage = Handle<deleteStage>;

// `access`: GL_MAP_READ_BIT or GL_MAP_WRITE_BIT.
Stage makeStage(std::size_t sizeBytes, GLbitfield access) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    Stage stage(name);
    const auto allocate = [&] {
        glNamedBufferStorage(name, GLsizeiptr(sizeBytes), nullptr, access | GL_CLIENT_STORAGE_BIT);
    };
    if (fails(allocate)) {
        throw GlError("the driver has no room for {} MiB to copy to or from the device; close other programs",
                      (sizeBytes >> 20) + 1);
    }
    return stage;
}

void* mapped(const Stage& stage, std::size_t sizeBytes, GLbitfield access) {
    void* bytes = glMapNamedBufferRange(stage.name(), 0, GLsizeiptr(sizeBytes), access);
    if (bytes == nullptr) {
        throw GlError(
            "the driver could not map {} bytes to copy to or from the device; its context may be lost",
            sizeBytes);
    }
    return bytes;
}

// Of the current context, made when it is first needed.
GLuint fillingProgram() {
    VS_CHECK(errorsCounted() != nullptr);
    GLuint& program = errorsCounted()->clearing;
    if (program == 0) {
        const std::string source = expandSource("gl/shaders/fill_words.comp", {}).text;
        const char* text = source.c_str();
        program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text);
    }
    return program;
}

} // namespace

bool areTransfersStaged() {
    const char* asked = std::getenv("VOLUME_STUDIO_TRANSFERS");
    return (asked != nullptr && std::string_view(asked) == "staged") || !Context::isSoftware();
}

void writeStaged(unsigned int buffer, std::size_t offset, std::span<const std::byte> bytes) {
    for (std::size_t done = 0; done < bytes.size(); done += kMostAtOnce) {
        const auto part = bytes.subspan(done, std::min(kMostAtOnce, bytes.size() - done));
        const Stage stage = makeStage(part.size(), GL_MAP_WRITE_BIT);
        std::memcpy(mapped(stage, part.size(), GL_MAP_WRITE_BIT), part.data(), part.size());
        glUnmapNamedBuffer(stage.name());
        glCopyNamedBufferSubData(stage.name(), buffer, 0, GLintptr(offset + done), GLsizeiptr(part.size()));
    }
}

void readStaged(unsigned int buffer, std::size_t offset, std::span<std::byte> bytes) {
    for (std::size_t done = 0; done < bytes.size(); done += kMostAtOnce) {
        const auto part = bytes.subspan(done, std::min(kMostAtOnce, bytes.size() - done));
        const Stage stage = makeStage(part.size(), GL_MAP_READ_BIT);
        glCopyNamedBufferSubData(buffer, stage.name(), GLintptr(offset + done), 0, GLsizeiptr(part.size()));
        std::memcpy(part.data(), mapped(stage, part.size(), GL_MAP_READ_BIT), part.size());
        glUnmapNamedBuffer(stage.name());
    }
}

void clearByDispatch(unsigned int buffer, std::size_t offset, std::size_t sizeBytes) {
    constexpr std::size_t bytesPerGroup = 256 * 16; // 4 words an invocation
    const GLuint program = fillingProgram();
    glProgramUniform1ui(program, glGetUniformLocation(program, "firstWord"), GLuint(offset / 4));
    glProgramUniform1ui(program, glGetUniformLocation(program, "wordCount"), GLuint(sizeBytes / 4));
    GLint boundBefore = 0; // whoever clears may be between two dispatches that use what is bound there
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &boundBefore);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
    glUseProgram(program);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glDispatchCompute(
        GLuint(std::min<std::size_t>((sizeBytes + bytesPerGroup - 1) / bytesPerGroup, kMaxGroups)), 1, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, GLuint(boundBefore));
}

} // namespace vs::gl

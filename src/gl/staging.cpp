// SPDX-License-Identifier: Apache-2.0
#include "gl/staging.h"

#include "base/check.h"
#include "base/error.h"
#include "gl/context.h"
#include "gl/errors.h"
#include "gl/program.h"
#include "gl/shader_source.h"
#include "gl/shaders/bindings.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace vs::gl {

namespace {

constexpr std::size_t kAlignment = 16;

Staging& staging() {
    VS_CHECK(currentRecord() != nullptr);
    return currentRecord()->staging;
}

// `access`: GL_MAP_READ_BIT or GL_MAP_WRITE_BIT.
void make(Staging::Window& window, GLbitfield access) {
    const GLbitfield mapping = access | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    glCreateBuffers(1, &window.name);
    const auto allocate = [&] {
        glNamedBufferStorage(window.name, GLsizeiptr(kWindowBytes), nullptr, mapping | GL_CLIENT_STORAGE_BIT);
        window.bytes =
            static_cast<std::byte*>(glMapNamedBufferRange(window.name, 0, GLsizeiptr(kWindowBytes), mapping));
    };
    if (fails(allocate) || window.bytes == nullptr) {
        glDeleteBuffers(1, &window.name);
        window = {};
        throw GlError("the driver has no room for the {} MiB through which bytes go to and from the device; "
                      "close other programs",
                      kWindowBytes >> 20);
    }
}

// Where the next bytes to be written may lie in the window; some at least are free.
std::size_t placeIn(Staging::Window& window) {
    if (window.name == 0) {
        make(window, GL_MAP_WRITE_BIT);
    }
    if (window.used == kWindowBytes) {
        glFinish();
        window.used = 0;
    }
    return window.used;
}

Staging::Window& windowToRead() {
    Staging::Window& window = staging().out;
    if (window.name == 0) {
        make(window, GL_MAP_READ_BIT);
    }
    return window;
}

void setUsed(Staging::Window& window, std::size_t end) {
    window.used = std::min(kWindowBytes, (end + kAlignment - 1) / kAlignment * kAlignment);
}

void withPixelBuffer(GLenum target, const Staging::Window& window, std::size_t at,
                     const PixelTransfer& transfer) {
    glBindBuffer(target, window.name);
    transfer(reinterpret_cast<void*>(at)); // NOLINT(performance-no-int-to-ptr): OpenGL's way to say an offset
    glBindBuffer(target, 0);
}

// Of the current context, made when it is first needed. No gl::Program: that must go while its context is
// current, and tells whoever watches hazards of dispatches that Buffer has told of already.
GLuint fillProgram() {
    GLuint& program = staging().fill;
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
    Staging::Window& window = staging().in;
    while (!bytes.empty()) {
        const std::size_t at = placeIn(window);
        const auto part = bytes.first(std::min(kWindowBytes - at, bytes.size()));
        std::memcpy(window.bytes + at, part.data(), part.size());
        glCopyNamedBufferSubData(window.name, buffer, GLintptr(at), GLintptr(offset),
                                 GLsizeiptr(part.size()));
        setUsed(window, at + part.size());
        offset += part.size();
        bytes = bytes.subspan(part.size());
    }
}

void readStaged(unsigned int buffer, std::size_t offset, std::span<std::byte> bytes) {
    Staging::Window& window = windowToRead();
    while (!bytes.empty()) {
        const auto part = bytes.first(std::min(kWindowBytes, bytes.size()));
        glCopyNamedBufferSubData(buffer, window.name, GLintptr(offset), 0, GLsizeiptr(part.size()));
        glFinish();
        std::memcpy(part.data(), window.bytes, part.size());
        offset += part.size();
        bytes = bytes.subspan(part.size());
    }
}

void writeStaged(std::span<const std::byte> texels, const PixelTransfer& transfer) {
    VS_CHECK(texels.size() <= kWindowBytes);
    Staging::Window& window = staging().in;
    if (placeIn(window) + texels.size() > kWindowBytes) {
        window.used = kWindowBytes; // what is left of it is too little
    }
    const std::size_t at = placeIn(window);
    std::memcpy(window.bytes + at, texels.data(), texels.size());
    withPixelBuffer(GL_PIXEL_UNPACK_BUFFER, window, at, transfer);
    setUsed(window, at + texels.size());
}

void readStaged(std::span<std::byte> texels, const PixelTransfer& transfer) {
    VS_CHECK(texels.size() <= kWindowBytes);
    Staging::Window& window = windowToRead();
    withPixelBuffer(GL_PIXEL_PACK_BUFFER, window, 0, transfer);
    glFinish();
    std::memcpy(texels.data(), window.bytes, texels.size());
}

void clearByDispatch(unsigned int buffer, std::size_t offset, std::size_t sizeBytes) {
    constexpr std::size_t bytesPerGroup = std::size_t(256) * 16; // 4 words an invocation
    const std::size_t groups = (sizeBytes + bytesPerGroup - 1) / bytesPerGroup;
    const GLuint program = fillProgram();
    glProgramUniform1ui(program, glGetUniformLocation(program, "firstWord"), GLuint(offset / 4));
    glProgramUniform1ui(program, glGetUniformLocation(program, "wordCount"), GLuint(sizeBytes / 4));
    GLint boundBefore = 0; // whoever clears may be between two dispatches that use what is bound there
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, kWordsStorage, &boundBefore);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kWordsStorage, buffer);
    glUseProgram(program);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glDispatchCompute(GLuint(std::min<std::size_t>(groups, kMaxGroups)), 1, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kWordsStorage, GLuint(boundBefore));
}

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
// Preloaded by bench/device_bytes: tells on standard error of each texture and buffer how many bytes it has,
// what it is called and when it goes.
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdio>

namespace {

template <typename Function>
Function driversOwn(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

long long bytesPerTexel(GLenum format) {
    switch (format) {
    case GL_R8:
    case GL_R8UI:
        return 1;
    case GL_R16:
    case GL_R16F:
    case GL_R16UI:
    case GL_RG8:
        return 2;
    case GL_R32F:
    case GL_R32UI:
    case GL_RG16:
    case GL_RGBA8:
        return 4;
    case GL_RG32F:
    case GL_RGBA16:
    case GL_RGBA16F:
        return 8;
    default: // RGBA32F, RGBA32UI
        return 16;
    }
}

void tellMade(char kind, GLuint name, long long bytes) {
    std::fprintf(stderr, "made %c %u %lld\n", kind, name, bytes);
}

void bufferStorage(GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
    static const auto own = driversOwn<PFNGLNAMEDBUFFERSTORAGEPROC>("glNamedBufferStorage");
    own(buffer, size, data, flags);
    tellMade('b', buffer, size);
}

void textureStorage2D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
    static const auto own = driversOwn<PFNGLTEXTURESTORAGE2DPROC>("glTextureStorage2D");
    own(texture, levels, format, width, height);
    tellMade('t', texture, bytesPerTexel(format) * width * height);
}

// Smaller levels of a pyramid are not counted: a seventh at most.
void textureStorage3D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                      GLsizei depth) {
    static const auto own = driversOwn<PFNGLTEXTURESTORAGE3DPROC>("glTextureStorage3D");
    own(texture, levels, format, width, height, depth);
    tellMade('t', texture, bytesPerTexel(format) * width * height * depth);
}

void objectLabel(GLenum kind, GLuint name, GLsizei length, const GLchar* label) {
    static const auto own = driversOwn<PFNGLOBJECTLABELPROC>("glObjectLabel");
    own(kind, name, length, label);
    if (kind == GL_BUFFER || kind == GL_TEXTURE) {
        std::fprintf(stderr, "called %c %u %s\n", kind == GL_BUFFER ? 'b' : 't', name, label);
    }
}

void deleteTextures(GLsizei count, const GLuint* names) {
    static const auto own = driversOwn<PFNGLDELETETEXTURESPROC>("glDeleteTextures");
    own(count, names);
    for (GLsizei n = 0; n < count; ++n) {
        std::fprintf(stderr, "gone t %u\n", names[n]);
    }
}

void deleteBuffers(GLsizei count, const GLuint* names) {
    static const auto own = driversOwn<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers");
    own(count, names);
    for (GLsizei n = 0; n < count; ++n) {
        std::fprintf(stderr, "gone b %u\n", names[n]);
    }
}

// The programs resolve OpenGL through libepoxy's pointers.
[[maybe_unused]] const bool isIn = [] {
    epoxy_glNamedBufferStorage = bufferStorage;
    epoxy_glTextureStorage2D = textureStorage2D;
    epoxy_glTextureStorage3D = textureStorage3D;
    epoxy_glObjectLabel = objectLabel;
    epoxy_glDeleteTextures = deleteTextures;
    epoxy_glDeleteBuffers = deleteBuffers;
    return true;
}();

} // namespace

// SPDX-License-Identifier: Apache-2.0
#include "gl/texture.h"

#include "base/check.h"
#include "base/error.h"
#include "gl/errors.h"
#include "gl/hazard_watch.h"
#include "gl/limits.h"
#include "gl/staging.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace vs::gl {

static_assert(std::is_nothrow_move_constructible_v<Texture> && std::is_nothrow_move_assignable_v<Texture>);

namespace detail {
void deleteTexture(unsigned int name) {
    glDeleteTextures(1, &name);
    noteDeleted({false, name});
    countDeleted(Counted::Texture, name);
}
} // namespace detail

namespace {

struct FormatInfo {
    GLenum internal;
    GLenum layout;
    GLenum type;
    std::size_t bytes;
};

FormatInfo info(Format format) {
    switch (format) {
    case Format::R8:
        return {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1};
    case Format::R16:
        return {GL_R16, GL_RED, GL_UNSIGNED_SHORT, 2};
    case Format::R16F:
        return {GL_R16F, GL_RED, GL_HALF_FLOAT, 2};
    case Format::R32F:
        return {GL_R32F, GL_RED, GL_FLOAT, 4};
    case Format::R8UI:
        return {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1};
    case Format::R16UI:
        return {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2};
    case Format::R32UI:
        return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
    case Format::RGBA32UI:
        return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16};
    case Format::RG8:
        return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2};
    case Format::RG16:
        return {GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 4};
    case Format::RG32F:
        return {GL_RG32F, GL_RG, GL_FLOAT, 8};
    case Format::RGBA8:
        return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
    case Format::RGBA16:
        return {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, 8};
    case Format::RGBA16F:
        return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8};
    case Format::RGBA32F:
        break;
    }
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
}

// Calls `work` with parts of a box of `most` bytes each at the most, whole slices or rows of one, and the
// byte at which each begins among the box's texels.
template <class Work>
void forEachPart(const Box3& box, std::size_t most, std::size_t texelBytes, const Work& work) {
    const glm::ivec3 size = box.size();
    const std::size_t row = std::size_t(std::max(size.x, 1)) * texelBytes;
    const std::size_t slice = row * std::size_t(std::max(size.y, 1));
    const int slices = int(std::clamp<std::size_t>(most / slice, 1, std::size_t(std::max(size.z, 1))));
    const int rows = int(std::clamp<std::size_t>(most / row, 1, std::size_t(std::max(size.y, 1))));
    std::size_t at = 0;
    for (int z = box.lo.z; z < box.hi.z; z += slices) {
        for (int y = box.lo.y; y < box.hi.y; y += rows) {
            const Box3 part{{box.lo.x, y, z},
                            {box.hi.x, std::min(y + rows, box.hi.y), std::min(z + slices, box.hi.z)}};
            work(part, at);
            at += part.volume() * texelBytes;
        }
    }
}

} // namespace

std::size_t bytesPerTexel(Format format) { return info(format).bytes; }

unsigned int internalFormat(Format format) { return info(format).internal; }

unsigned int glAccess(Access access) {
    return access == Access::Read ? GL_READ_ONLY : access == Access::Write ? GL_WRITE_ONLY : GL_READ_WRITE;
}

std::size_t Texture::bytes() const {
    std::size_t texels = 0;
    for (int level = 0; level < levels_; ++level) {
        texels += Box3{glm::ivec3(0), size(level)}.volume();
    }
    return size_ == glm::ivec3(0) ? 0 : texels * bytesPerTexel(format_);
}

Texture::Texture(glm::ivec3 size, Format format, Filter filter, const std::string& label)
    : size_(size), format_(format) {
    create(label, filter);
}

Texture::Texture(glm::ivec2 size, Format format, Filter filter, const std::string& label)
    : size_(size, 1), format_(format), is3D_(false) {
    create(label, filter);
}

Texture Texture::pyramid(glm::ivec3 size, Format format, int levels, const std::string& label) {
    Texture texture;
    texture.size_ = size;
    texture.format_ = format;
    texture.levels_ = levels;
    texture.create(label, Filter::Linear);
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(texture.name(), axis, GL_CLAMP_TO_BORDER);
    }
    return texture;
}

void Texture::create(const std::string& label, Filter filter) {
    isStaged_ = areTransfersStaged();
    const int limit = is3D_ ? limits().texture3D : limits().texture2D;
    const char* remedy =
        is3D_ ? "use a smaller volume, as vstudio reduce makes, or another device" : "use a smaller picture";
    if (std::max({size_.x, size_.y, size_.z}) > limit) {
        throw GlError("{}: {}x{}x{} texels are more than this device's limit of {} along an axis; {}", label,
                      size_.x, size_.y, size_.z, limit, remedy);
    }
    GLuint name = 0;
    glCreateTextures(is3D_ ? GL_TEXTURE_3D : GL_TEXTURE_2D, 1, &name);
    handle_ = Handle<detail::deleteTexture>(name);
    const GLenum internal = info(format_).internal;
    const auto allocate = [&] {
        if (is3D_) {
            glTextureStorage3D(name, levels_, internal, size_.x, size_.y, size_.z);
        } else {
            glTextureStorage2D(name, 1, internal, size_.x, size_.y);
        }
    };
    if (fails(allocate)) {
        throw GlError("{}: the device has no room for {}x{}x{} texels ({} MiB); {}", label, size_.x, size_.y,
                      size_.z, bytes() >> 20, remedy);
    }
    if (is3D_) {
        countMade(Counted::Texture, name, bytes());
    }
    glObjectLabel(GL_TEXTURE, name, -1, label.c_str());
    const GLint mode = filter == Filter::Linear ? GL_LINEAR : GL_NEAREST;
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, mode);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, mode);
    // Mirrored, not plain, clamping: with plain clamping llvmpipe filters 8-bit textures in 8-bit arithmetic,
    // which shows as wood grain on surfaces; this keeps it in floats, and is no slower. Within a texel of the
    // border both are equal.
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(name, axis, GL_MIRROR_CLAMP_TO_EDGE);
    }
    clear();
}

void Texture::upload(const Box3& box, std::span<const std::byte> texels) {
    VS_CHECK_EQ(texels.size(), box.volume() * bytesPerTexel(format_));
    const FormatInfo f = info(format_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    memoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    noteTextureCommand("Texture::upload", name(), Does::Write);
    forEachPart(
        box, isStaged_ ? kWindowBytes : texels.size(), f.bytes, [&](const Box3& part, std::size_t at) {
            const glm::ivec3 s = part.size();
            const auto bytes = texels.subspan(at, part.volume() * f.bytes);
            const auto give = [&](const void* from) {
                if (is3D_) {
                    glTextureSubImage3D(name(), 0, part.lo.x, part.lo.y, part.lo.z, s.x, s.y, s.z, f.layout,
                                        f.type, from);
                } else {
                    glTextureSubImage2D(name(), 0, part.lo.x, part.lo.y, s.x, s.y, f.layout, f.type, from);
                }
            };
            if (isStaged_) {
                writeStaged(bytes, give);
            } else {
                give(bytes.data());
            }
        });
}

std::vector<std::byte> Texture::download(const Box3& box, int level) const {
    const FormatInfo f = info(format_);
    std::vector<std::byte> texels(box.volume() * f.bytes);
    if (texels.empty()) {
        return texels;
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    // Image stores must be visible to the read-back.
    memoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    noteTextureCommand("Texture::download", name(), Does::Read);
    forEachPart(box, isStaged_ ? kWindowBytes : texels.size(), f.bytes,
                [&](const Box3& part, std::size_t at) {
                    const glm::ivec3 s = part.size();
                    const auto bytes = std::span(texels).subspan(at, part.volume() * f.bytes);
                    const auto take = [&](void* to) {
                        glGetTextureSubImage(name(), level, part.lo.x, part.lo.y, part.lo.z, s.x, s.y, s.z,
                                             f.layout, f.type, GLsizei(bytes.size()), to);
                    };
                    if (isStaged_) {
                        readStaged(bytes, take);
                    } else {
                        take(bytes.data());
                    }
                });
    return texels;
}

void Texture::copyFrom(const Texture& source, const Box3& sourceBox, glm::ivec3 destination) {
    VS_CHECK(format_ == source.format_);
    const glm::ivec3 s = sourceBox.size();
    const GLenum target = is3D_ ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    memoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    noteTextureCommand("Texture::copyFrom", source.name(), Does::CopyFrom);
    noteTextureCommand("Texture::copyFrom", name(), Does::Write);
    glCopyImageSubData(source.name(), target, 0, sourceBox.lo.x, sourceBox.lo.y, sourceBox.lo.z, name(),
                       target, 0, destination.x, destination.y, destination.z, s.x, s.y, s.z);
    // Image stores that follow must not come before the source has been read.
    memoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void Texture::clear() {
    const FormatInfo f = info(format_);
    memoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    noteTextureCommand("Texture::clear", name(), Does::Fill);
    for (int level = 0; level < levels_; ++level) {
        glClearTexImage(name(), level, f.layout, f.type, nullptr);
    }
}

void Texture::clear(const Box3& box) {
    const FormatInfo f = info(format_);
    const glm::ivec3 s = box.size();
    if (!box.isEmpty()) {
        memoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        noteTextureCommand("Texture::clear", name(), Does::Write);
        glClearTexSubImage(name(), 0, box.lo.x, box.lo.y, box.lo.z, s.x, s.y, s.z, f.layout, f.type, nullptr);
    }
}

void Texture::clear(unsigned int value) { clear({glm::ivec3(0), size_}, value); }

void Texture::clear(const Box3& box, unsigned int value) {
    VS_CHECK(format_ == Format::R8UI || format_ == Format::R16UI || format_ == Format::R32UI);
    const glm::ivec3 s = box.size();
    if (!box.isEmpty()) {
        memoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        noteTextureCommand("Texture::clear", name(), Does::Write);
        glClearTexSubImage(name(), 0, box.lo.x, box.lo.y, box.lo.z, s.x, s.y, s.z, GL_RED_INTEGER,
                           GL_UNSIGNED_INT, &value);
    }
}

void Texture::bindTexture(unsigned int unit) const { glBindTextureUnit(unit, name()); }

void Texture::bindImage(unsigned int unit, Access access, int level) const {
    glBindImageTexture(unit, name(), level, is3D_ ? GL_TRUE : GL_FALSE, 0, glAccess(access),
                       info(format_).internal);
}

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#include "gl/buffer.h"

#include "base/error.h"
#include "base/large_pages.h"
#include "gl/errors.h"
#include "gl/hazard_watch.h"
#include "gl/limits.h"
#include "gl/staging.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace vs::gl {

static_assert(std::is_nothrow_move_constructible_v<Buffer> && std::is_nothrow_move_assignable_v<Buffer>);

namespace detail {
void deleteBuffer(unsigned int name) {
    glDeleteBuffers(1, &name);
    noteDeleted({true, name});
    countDeleted(Counted::Buffer, name);
}
} // namespace detail

Buffer::Buffer(std::size_t sizeBytes, const std::string& label, Reach reach)
    : size_(std::max<std::size_t>(sizeBytes, 4)), label_(label), isStaged_(areTransfersStaged()) {
    if (const std::size_t limit = limits().storageBlockBytes; size_ > limit) {
        throw GlError("{}: {} MiB are more than this device's limit of {} MiB for a storage block; use a "
                      "smaller volume, as vstudio reduce makes, or another device",
                      label, size_ >> 20, limit >> 20);
    }
    GLuint name = 0;
    glCreateBuffers(1, &name);
    handle_ = Handle<detail::deleteBuffer>(name);
    constexpr GLbitfield mapping =
        GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const bool isShared = reach == Reach::Shared;
    const auto make = [&] {
        glNamedBufferStorage(name, GLsizeiptr(size_), nullptr,
                             (isStaged_ ? 0 : GL_DYNAMIC_STORAGE_BIT) | (isShared ? mapping : 0));
        if (isShared) {
            shared_ = static_cast<std::byte*>(glMapNamedBufferRange(name, 0, GLsizeiptr(size_), mapping));
        }
    };
    if (fails(make) || (isShared && shared_ == nullptr)) {
        throw GlError("{}: the device has no room for {} MiB; use a smaller volume, as vstudio "
                      "reduce makes, or another device",
                      label, size_ >> 20);
    }
    countMade(Counted::Buffer, name, size_);
    glObjectLabel(GL_BUFFER, name, -1, label.c_str());
    if (isShared) {
        askForLargePages(shared());
    }
    clear();
    if (isShared) {
        glFinish(); // the host may write from now on, which must not come before the zeros
    }
}

void Buffer::write(std::span<const std::byte> bytes, std::size_t offset) {
    VS_CHECK(offset + bytes.size() <= size_);
    if (!bytes.empty()) {
        // What shaders have written before must not come after it.
        memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        noteBufferCommand("Buffer::write", name(), bytes.size() == size_ ? Does::Fill : Does::Write);
        if (isStaged_) {
            writeStaged(name(), offset, bytes);
        } else {
            glNamedBufferSubData(name(), GLintptr(offset), GLsizeiptr(bytes.size()), bytes.data());
        }
    }
}

void Buffer::read(std::span<std::byte> bytes, std::size_t offset) const {
    VS_CHECK(offset + bytes.size() <= size_);
    if (bytes.empty()) {
        return;
    }
    // Shader writes must be visible to the copy.
    memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    noteBufferCommand("Buffer::read", name(), Does::Read);
    if (isStaged_) {
        readStaged(name(), offset, bytes);
    } else {
        glGetNamedBufferSubData(name(), GLintptr(offset), GLsizeiptr(bytes.size()), bytes.data());
    }
}

std::span<std::byte> Buffer::shared() const {
    VS_CHECK(shared_ != nullptr);
    return {shared_, size_};
}

void Buffer::waitForDevice() {
    memoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    glFinish();
}

void Buffer::clear(std::size_t offset, std::size_t sizeBytes) {
    const std::size_t cleared = sizeBytes == 0 ? (size_ - offset) / 4 * 4 : sizeBytes;
    memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    noteBufferCommand("Buffer::clear", name(), cleared == size_ ? Does::Fill : Does::Write);
    if (isStaged_) {
        clearByDispatch(name(), offset, cleared);
        return;
    }
    const GLuint zero = 0;
    glClearNamedBufferSubData(name(), GL_R32UI, GLintptr(offset), GLsizeiptr(cleared), GL_RED_INTEGER,
                              GL_UNSIGNED_INT, &zero);
}

void Buffer::reserve(std::size_t sizeBytes) {
    if (sizeBytes > size_) {
        *this = Buffer(std::max(sizeBytes, size_ + size_ / 2), std::string(label_),
                       shared_ != nullptr ? Reach::Shared : Reach::Device);
    }
}

void Buffer::bindStorage(unsigned int binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name());
}

void Buffer::bindUniform(unsigned int binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, name()); }

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#include "gpu/faults/faults.h"

#include "gl/hazard_watch.h"
#include "gpu/faults/own_code.h"

#include <epoxy/gl.h>

#include <epoxy/egl.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

struct Refusal {
    std::atomic<bool> isOn = false;
    std::atomic<std::size_t> wanted = 0;
    std::atomic<std::size_t> count = 0;
    std::atomic<bool> hasHappened = false;

    // Counts one; whether it is the one to be refused.
    bool comes() {
        const std::size_t number = ++count;
        if (number != wanted) {
            return false;
        }
        hasHappened = true;
        return true;
    }
};

Refusal onHost;
Refusal onDevice;
thread_local bool isLooking = false; // at the stack, which may need memory itself

bool isRefused() {
    if (!onHost.isOn || isLooking || onHost.hasHappened || vs::gl::isWatcherAtWork()) {
        return false;
    }
    isLooking = true;
    const bool isOwn = vs::test::isCalledByOwnCode();
    isLooking = false;
    return isOwn && onHost.comes();
}

void* allocated(std::size_t size, std::size_t alignment) {
    if (isRefused()) {
        return nullptr;
    }
    const std::size_t whole = size == 0 ? 1 : size;
    return alignment == 0 ? std::malloc(whole)
                          : std::aligned_alloc(alignment, (whole + alignment - 1) / alignment * alignment);
}

void* allocatedOrThrown(std::size_t size, std::size_t alignment) {
    void* memory = allocated(size, alignment);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

} // namespace

// NOLINTBEGIN(readability-identifier-naming,misc-definitions-in-headers)
void* operator new(std::size_t size) { return allocatedOrThrown(size, 0); }
void* operator new[](std::size_t size) { return allocatedOrThrown(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocatedOrThrown(size, std::size_t(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return allocatedOrThrown(size, std::size_t(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocated(size, 0); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocated(size, 0); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
// NOLINTEND(readability-identifier-naming,misc-definitions-in-headers)

namespace vs::test {

namespace {

// What a driver without room does: it makes no storage, and says GL_OUT_OF_MEMORY to whoever asks. The
// driver's own functions are asked for by their names; epoxy's pointers lead here.
thread_local bool isOutOfMemory = false;

template <typename Function>
Function driversOwn(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

GLenum error() {
    static const auto own = driversOwn<PFNGLGETERRORPROC>("glGetError");
    if (isOutOfMemory) {
        isOutOfMemory = false;
        return GL_OUT_OF_MEMORY;
    }
    return own();
}

bool isRefusedByDevice() {
    const bool isIt = onDevice.isOn && onDevice.comes();
    isOutOfMemory = isOutOfMemory || isIt;
    return isIt;
}

void bufferStorage(GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
    static const auto own = driversOwn<PFNGLNAMEDBUFFERSTORAGEPROC>("glNamedBufferStorage");
    if (!isRefusedByDevice()) {
        own(buffer, size, data, flags);
    }
}

void textureStorage2D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
    static const auto own = driversOwn<PFNGLTEXTURESTORAGE2DPROC>("glTextureStorage2D");
    if (!isRefusedByDevice()) {
        own(texture, levels, format, width, height);
    }
}

void textureStorage3D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                      GLsizei depth) {
    static const auto own = driversOwn<PFNGLTEXTURESTORAGE3DPROC>("glTextureStorage3D");
    if (!isRefusedByDevice()) {
        own(texture, levels, format, width, height, depth);
    }
}

void interpose() {
    epoxy_glGetError = error;
    epoxy_glNamedBufferStorage = bufferStorage;
    epoxy_glTextureStorage2D = textureStorage2D;
    epoxy_glTextureStorage3D = textureStorage3D;
}

Refusal& of(Memory memory) { return memory == Memory::Host ? onHost : onDevice; }
Refusal* present = nullptr;

} // namespace

RefusedAllocation::RefusedAllocation(Memory memory, std::size_t number) : number_(number) {
    interpose();
    static_cast<void>(isCalledByOwnCode()); // reads its tables now
    present = &of(memory);
    present->wanted = number;
    present->count = 0;
    present->hasHappened = false;
    present->isOn = true;
}

RefusedAllocation::~RefusedAllocation() { present->isOn = false; }

std::size_t RefusedAllocation::count() const { return present->count; }
bool RefusedAllocation::hasHappened() const { return number_ > 0 && present->hasHappened; }

} // namespace vs::test

// SPDX-License-Identifier: Apache-2.0
#include "gl/limits.h"

#include "gl/context.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>

namespace vs::gl {

Limits limits() {
    const char* pretended = std::getenv("VOLUME_STUDIO_LIMITS");
    if (pretended != nullptr && std::string_view(pretended) == "guaranteed") {
        return kGuaranteedLimits;
    }
    Limits out;
    GLint texels = 0;
    GLint64 bytes = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &out.texture2D);
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &out.texture3D);
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    out.texelBufferTexels = std::size_t(texels);
    // Mesa's software renderers name the least that is allowed, and work on whole buffers, whose bytes they
    // count with 32 bits.
    out.storageBlockBytes =
        Context::isSoftware() ? std::numeric_limits<std::uint32_t>::max() : std::size_t(bytes);
    return out;
}

int pretendedFilterSteps() {
    const char* asked = std::getenv("VOLUME_STUDIO_FILTER_STEPS");
    return asked == nullptr ? 0 : std::max(std::atoi(asked), 0);
}

ComputeLimits computeLimits() {
    ComputeLimits out;
    for (int axis = 0; axis < 3; ++axis) {
        glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, GLuint(axis), &out.groups[axis]);
        glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_SIZE, GLuint(axis), &out.groupSize[axis]);
    }
    glGetIntegerv(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, &out.groupInvocations);
    glGetIntegerv(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, &out.sharedBytes);
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &out.storageBlocks);
    glGetIntegerv(GL_MAX_COMPUTE_IMAGE_UNIFORMS, &out.images);
    glGetIntegerv(GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, &out.textures);
    return out;
}

namespace {

std::atomic<std::size_t> memoryOfDevice{0};

} // namespace

std::size_t deviceMemoryBytes() { return memoryOfDevice; }

void noteDeviceMemory() {
    GLint own = 0; // both in KiB
    GLint all = 0;
    if (!Context::isSoftware() && epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) {
        glGetIntegerv(GL_GPU_MEMORY_INFO_DEDICATED_VIDMEM_NVX, &own);
        glGetIntegerv(GL_GPU_MEMORY_INFO_TOTAL_AVAILABLE_MEMORY_NVX, &all);
    }
    const bool isShared = own < all / 4; // a graphics core of the processor, with a little set aside for it
    memoryOfDevice = isShared ? 0 : std::size_t(std::max(own, 0)) * 1024;
}

namespace {

struct Counts {
    std::mutex mutex;
    std::map<std::pair<Counted, unsigned int>, std::size_t> sizes;
    DeviceBytes bytes;
};

// Never destroyed: textures may be deleted at the very end of a program.
Counts& counts() {
    static auto* const all = new Counts;
    return *all;
}

} // namespace

DeviceBytes deviceBytes() {
    const std::lock_guard lock(counts().mutex);
    return counts().bytes;
}

void countMade(Counted kind, unsigned int name, std::size_t bytes) {
    Counts& all = counts();
    const std::lock_guard lock(all.mutex);
    all.sizes[{kind, name}] = bytes;
    all.bytes.now += bytes;
    all.bytes.peak = std::max(all.bytes.peak, all.bytes.now);
}

void countDeleted(Counted kind, unsigned int name) {
    Counts& all = counts();
    const std::lock_guard lock(all.mutex);
    const auto found = all.sizes.find({kind, name});
    if (found != all.sizes.end()) {
        all.bytes.now -= found->second;
        all.sizes.erase(found);
    }
}

} // namespace vs::gl

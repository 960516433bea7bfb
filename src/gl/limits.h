// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>

namespace vs::gl {

// How large things may be on a device.
struct Limits {
    int texture2D = 0; // texels along an axis
    int texture3D = 0;
    std::size_t texelBufferTexels = 0;
    std::size_t storageBlockBytes = 0;
};

// The limits of the current context's device. With VOLUME_STUDIO_LIMITS=guaranteed those that every device
// has at least, so that tests can see what becomes of a small one.
Limits limits();

// What every device with OpenGL 4.5 has at least (OpenGL 4.5 core, tables 23.53 to 23.68).
inline constexpr Limits kGuaranteedLimits{16384, 2048, 65536, std::size_t(1) << 27};

// How much one dispatch and one shader may take on a device.
struct ComputeLimits {
    glm::ivec3 groups{0};    // of a dispatch, along each axis
    glm::ivec3 groupSize{0}; // invocations of a group along each axis
    int groupInvocations = 0;
    int sharedBytes = 0;
    int storageBlocks = 0; // of a compute shader
    int images = 0;
    int textures = 0;
};

// Steps that a texture unit has from one texel to the next, where one is pretended by
// VOLUME_STUDIO_FILTER_STEPS (hardware has 256 and software as many as floats have, so that tests can see on
// the one what the other gives); 0: the device's own. Programs are then compiled with FILTER_STEPS, which
// field/shaders/scene.glsl heeds.
int pretendedFilterSteps();

// What the driver of the current context's device says of compute shaders.
ComputeLimits computeLimits();

// The memory of its own that the device has which a context was made on last, in bytes, as its driver says
// (GL_NVX_gpu_memory_info); 0: none was made, or its driver does not say, or most of what the device may take
// is the machine's. Any thread may ask.
std::size_t deviceMemoryBytes();
// Asks the driver of the current context. Internal to this folder.
void noteDeviceMemory();

// What volumes and what belongs to them take on the device: 3D textures and buffers, of all contexts.
// Pictures, which are 2D textures, are not counted.
struct DeviceBytes {
    std::size_t now = 0;
    std::size_t peak = 0; // the most that there were at any time
};
DeviceBytes deviceBytes();

// Internal to this folder.
enum class Counted : std::uint8_t { Texture, Buffer };
void countMade(Counted kind, unsigned int name, std::size_t bytes);
void countDeleted(Counted kind, unsigned int name);

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

// How bytes come to buffers that only the device can reach, and back. Internal to this folder; others call
// Buffer::write() and Buffer::read().
namespace vs::gl {

// Whether new buffers are made out of the host's reach: on hardware, where a driver may keep a second copy of
// a buffer that the host can reach, moves it to and fro, and has been seen to lose the order of clears,
// uploads and what indirect dispatches read. A software renderer's memory is the host's own.
// VOLUME_STUDIO_TRANSFERS=staged asks for it on any device, so that tests can.
[[nodiscard]] bool areTransfersStaged();

// Copies through a short-lived buffer that host and device share, in the device's own order of work. Offsets
// are in bytes. Throw GlError when there is no room for that buffer.
void writeStaged(unsigned int buffer, std::size_t offset, std::span<const std::byte> bytes);
void readStaged(unsigned int buffer, std::size_t offset, std::span<std::byte> bytes); // waits for the device

// Sets bytes to zero by a dispatch with barriers around it; both numbers are multiples of 4. (NVIDIA's
// glClearNamedBufferSubData has been seen to come after later uploads and dispatches; driver 580.159.)
void clearByDispatch(unsigned int buffer, std::size_t offset, std::size_t sizeBytes);

} // namespace vs::gl

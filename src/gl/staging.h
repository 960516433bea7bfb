// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>

// How bytes come to buffers and textures that only the device can reach, and back. Internal to this folder;
// others call Buffer::write() and Buffer::read(), Texture::upload() and Texture::download().
namespace vs::gl {

// Whether new buffers are made out of the host's reach: on hardware, where a driver may keep a second copy of
// a buffer that the host can reach, moves it to and fro, and has been seen to lose the order of clears,
// uploads and what indirect dispatches read (doc/decisions/0032). A software renderer's memory is the host's
// own. VOLUME_STUDIO_TRANSFERS=staged asks for it on any device, so that tests can.
[[nodiscard]] bool areTransfersStaged();

// What staging keeps in each context, made when it is first needed. The context's end is the end of it.
struct Staging {
    // A buffer that host and device share, mapped for good.
    struct Window {
        unsigned int name = 0;
        std::byte* bytes = nullptr;
        std::size_t used = 0; // by copies that the device may not have made yet
    };
    Window in;
    Window out;
    unsigned int fill = 0; // the program of shaders/fill_words.comp
};

// Copies in the device's own order of work. Offsets are in bytes. Throw GlError when the driver has no room
// for what host and device share.
void writeStaged(unsigned int buffer, std::size_t offset, std::span<const std::byte> bytes);
void readStaged(unsigned int buffer, std::size_t offset, std::span<std::byte> bytes); // waits for the device

// What a window holds at the most.
inline constexpr std::size_t kWindowBytes = std::size_t(8) << 20;

// For what goes to or comes from a texture's texels, of kWindowBytes at the most: `transfer` is
// called with the window bound as GL's pixel buffer, and with the place in it that stands for a pointer.
using PixelTransfer = std::function<void(void* place)>;
void writeStaged(std::span<const std::byte> texels, const PixelTransfer& transfer);
void readStaged(std::span<std::byte> texels, const PixelTransfer& transfer); // waits for the device

// Sets bytes to zero by a dispatch with barriers around it; both numbers are multiples of 4.
void clearByDispatch(unsigned int buffer, std::size_t offset, std::size_t sizeBytes);

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/buffer.h"
#include "gl/texture.h"

namespace vs::gl {

// Memory that shaders read as a row of texels (samplerBuffer), unfiltered. All calls need a current context.
class TexelBuffer {
public:
    TexelBuffer() = default;
    // Contents start as zeros. Throws GlError when the device cannot hold it; there are mostTexels() at most.
    TexelBuffer(std::size_t texels, Format format, const std::string& label, Reach reach = Reach::Device);

    static std::size_t mostTexels();

    [[nodiscard]] std::size_t texels() const { return texels_; }
    explicit operator bool() const { return bool(view_); }

    // Writes tightly packed texels, from the one with number `first` on.
    void write(std::span<const std::byte> bytes, std::size_t first);
    // The texels' memory as a buffer, for shaders that write it.
    [[nodiscard]] Buffer& buffer() { return buffer_; }
    [[nodiscard]] const Buffer& buffer() const { return buffer_; }

    void bindTexture(unsigned int unit) const;
    void bindImage(unsigned int unit, Access access) const; // imageBuffer

private:
    Buffer buffer_;
    Handle<detail::deleteTexture> view_;
    std::size_t texels_ = 0;
    Format format_ = Format::R8;
};

} // namespace vs::gl

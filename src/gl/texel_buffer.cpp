// SPDX-License-Identifier: Apache-2.0
#include "gl/texel_buffer.h"

#include "base/error.h"
#include "gl/limits.h"

#include <epoxy/gl.h>

namespace vs::gl {

namespace {

std::size_t checkedBytes(std::size_t texels, Format format, const std::string& label) {
    if (texels > TexelBuffer::mostTexels()) {
        throw GlError(
            "{}: {} texels are more than this device's limit of {}; use a smaller volume, as vstudio "
            "reduce makes, or another device",
            label, texels, TexelBuffer::mostTexels());
    }
    return texels * bytesPerTexel(format);
}

} // namespace

TexelBuffer::TexelBuffer(std::size_t texels, Format format, const std::string& label, Reach reach)
    : buffer_(checkedBytes(texels, format, label), label, reach), texels_(texels), format_(format) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
    view_ = Handle<detail::deleteTexture>(name);
    glTextureBuffer(name, internalFormat(format), buffer_.name());
    glObjectLabel(GL_TEXTURE, name, -1, label.c_str());
}

std::size_t TexelBuffer::mostTexels() { return limits().texelBufferTexels; }

void TexelBuffer::write(std::span<const std::byte> bytes, std::size_t first) {
    buffer_.write(bytes, first * bytesPerTexel(format_));
}

void TexelBuffer::bindImage(unsigned int unit, Access access) const {
    glBindImageTexture(unit, view_.name(), 0, GL_FALSE, 0, glAccess(access), internalFormat(format_));
}

void TexelBuffer::bindTexture(unsigned int unit) const { glBindTextureUnit(unit, view_.name()); }

} // namespace vs::gl

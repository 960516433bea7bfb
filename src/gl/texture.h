// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/handle.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vs::gl {

namespace detail {
void deleteTexture(unsigned int name);
}

enum class Format {
    R8,
    R16,
    R16F,
    R32F,
    R8UI,
    R16UI,
    R32UI,
    RGBA32UI,
    RG8,
    RG16,
    RG32F,
    RGBA8,
    RGBA16,
    RGBA16F,
    RGBA32F
};
std::size_t bytesPerTexel(Format format);
unsigned int internalFormat(Format format); // OpenGL's name for it

enum class Filter { Nearest, Linear };
enum class Access { Read, Write, ReadWrite };
unsigned int glAccess(Access access); // OpenGL's name for it

// A grid of texels on the device, three- or two-dimensional (a 2D texture has size.z == 1 and is a
// GL_TEXTURE_2D). Coordinates above the upper border give the nearest texel, those below the lower one are
// mirrored there; so up to half a texel outside it is the nearest one too. All calls need a current context.
class Texture {
public:
    Texture() = default;
    // Makes a 3D texture. Contents start as zeros. Throws GlError when the device cannot hold it, naming size
    // and limit.
    Texture(glm::ivec3 size, Format format, Filter filter, const std::string& label);
    // Makes a 2D texture. Contents start as zeros.
    Texture(glm::ivec2 size, Format format, Filter filter, const std::string& label);

    // Makes a 3D texture with `levels` levels, each half as wide as the one before (rounded down), for
    // shaders to look up with textureLod(): linear within the nearest level. Coordinates outside give zero.
    // Contents start as zeros.
    static Texture pyramid(glm::ivec3 size, Format format, int levels, const std::string& label);

    [[nodiscard]] glm::ivec3 size() const { return size_; }
    [[nodiscard]] glm::ivec3 size(int level) const { return glm::max(size_ >> level, glm::ivec3(1)); }
    [[nodiscard]] Format format() const { return format_; }
    [[nodiscard]] unsigned int name() const { return handle_.name(); }
    explicit operator bool() const { return bool(handle_); }

    // Writes the texels of `box` (half open, must lie inside), x fastest, tightly packed in the texture's own
    // format.
    void upload(const Box3& box, std::span<const std::byte> texels);
    [[nodiscard]] std::vector<std::byte> download(const Box3& box, int level = 0) const;
    template <typename T>
    [[nodiscard]] std::vector<T> downloadAll() const {
        const auto raw = download({glm::ivec3(0), size_});
        std::vector<T> values(raw.size() / sizeof(T));
        std::copy(raw.begin(), raw.end(), reinterpret_cast<std::byte*>(values.data()));
        return values;
    }
    void copyFrom(const Texture& source, const Box3& sourceBox, glm::ivec3 destination);
    // Sets all texels, or those of `box`, to zero or to one unsigned value (integer formats).
    void clear();
    void clear(const Box3& box);
    void clear(unsigned int value);
    void clear(const Box3& box, unsigned int value);

    void bindTexture(unsigned int unit) const;
    void bindImage(unsigned int unit, Access access, int level = 0) const;

private:
    void create(const std::string& label, Filter filter);
    [[nodiscard]] std::size_t bytes() const;

    Handle<detail::deleteTexture> handle_;
    glm::ivec3 size_{0};
    Format format_ = Format::R8;
    bool is3D_ = true;
    int levels_ = 1;
    bool isStaged_ = false; // texels come and go by a window that host and device share (gl/staging.h)
};

} // namespace vs::gl

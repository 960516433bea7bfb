// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include "base/atomic_file.h"
#include "base/error.h"

#include <png.h>

#include <memory>

namespace vs::image {

void writePng(const std::filesystem::path& path, const Image& image) {
    writeAtomically(path, [&](const std::filesystem::path& temporary) {
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        png.width = png_uint_32(image.width);
        png.height = png_uint_32(image.height);
        png.format = PNG_FORMAT_RGBA;
        if (png_image_write_to_file(&png, temporary.c_str(), 0, image.rgba.data(), 0, nullptr) == 0) {
            throw WriteError("{}", png.message);
        }
    });
}

Image readPng(const std::filesystem::path& path, const std::function<void(std::size_t)>& promised) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&png, path.c_str()) == 0) {
        throw ReadError("{}: not a readable PNG ({})", path.string(), png.message);
    }
    // What it holds, where the rest throws.
    const std::unique_ptr<png_image, void (*)(png_image*)> owner(&png, png_image_free);
    png.format = PNG_FORMAT_RGBA;
    if (promised) {
        promised(std::size_t(4) * png.width * png.height);
    }
    Image image(int(png.width), int(png.height));
    if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0) {
        throw ReadError("{}: damaged PNG ({})", path.string(), png.message);
    }
    return image;
}

} // namespace vs::image

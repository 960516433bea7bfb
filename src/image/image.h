// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace vs::image {

// 8-bit sRGB picture with straight alpha, rows from the top, four bytes a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    Image() = default;
    Image(int w, int h) : width(w), height(h), rgba(std::size_t(w) * std::size_t(h) * 4) {}

    [[nodiscard]] std::uint8_t* pixel(int x, int y) {
        return rgba.data() + 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
    }
    [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
        return rgba.data() + 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
    }
};

// Writes a PNG atomically (temporary file, sync, rename). Throws WriteError naming the file.
void writePng(const std::filesystem::path& path, const Image& image);

// Reads a PNG; `promised` hears, before anything is allocated, how many bytes its pixels take. Throws
// ReadError naming the file. For files that this program has written: those that people give are read by
// volume/reading/read_picture.h.
Image readPng(const std::filesystem::path& path, const std::function<void(std::size_t bytes)>& promised = {});

} // namespace vs::image

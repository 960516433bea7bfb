// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/inspect.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

struct tiff;

namespace vs::volume {

// One page of a TIFF or BigTIFF file: a picture of one value a pixel.
struct TiffPage {
    std::int64_t width = 0;
    std::int64_t height = 0;
    StoredType type = StoredType::UInt8;
    bool isInverted = false; // 0 is white in the file; values that are read are the other way round

    bool operator==(const TiffPage&) const = default;
    [[nodiscard]] std::size_t rowBytes() const { return std::size_t(width) * bytesOf(type); }
    [[nodiscard]] std::uint64_t bytes() const { return std::uint64_t(height) * rowBytes(); }
};

// A file of pages, read by libtiff. What it throws are ReadErrors that name the file.
class TiffFile {
public:
    explicit TiffFile(const std::filesystem::path& path);

    // Pages, without those that only show another one smaller.
    [[nodiscard]] std::int64_t pages();
    // Whether there is but one; quicker than counting.
    bool isSinglePage();
    // Refuses what is no picture of one value a pixel.
    TiffPage page(std::int64_t number);
    // A page's values, rows from the top, in this machine's byte order.
    void read(std::int64_t number, std::span<std::byte> values);
    // The first page's text (tag ImageDescription), where programs write what is beyond the format.
    std::string description();
    // Pixels along x and along y that the first page says lie in one of its units; 0 where it does not.
    glm::dvec2 resolution();
    // Whether that unit is the centimetre. Inches are mostly a printer's, whatever the picture shows.
    bool isPerCentimetre();
    // Where the first page's values begin in the file, if they lie there as they are and in one piece; 0 if
    // not.
    std::uint64_t plainOffset();
    // A page that lies there as it is, at an offset.
    void readPlain(std::uint64_t offset, std::span<std::byte> values);

private:
    void go(std::int64_t number);
    void readStrips(std::int64_t number, const TiffPage& page, std::span<std::byte> values);
    void readTiles(std::int64_t number, const TiffPage& page, std::span<std::byte> values);

    struct Close {
        void operator()(tiff* file) const;
    };
    std::filesystem::path path_;
    std::unique_ptr<tiff, Close> file_;
    std::int64_t at_ = 0; // the page that libtiff stands at
    std::int64_t pages_ = -1;
};

} // namespace vs::volume

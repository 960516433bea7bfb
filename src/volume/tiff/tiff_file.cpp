// SPDX-License-Identifier: Apache-2.0
#include "volume/tiff/tiff_file.h"

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

namespace vs::volume {

namespace {

// What libtiff said last. Only the decoder reads, one file at a time.
std::string& lastError() {
    static std::string text;
    return text;
}

void noteError(const char* /*module*/, const char* format, va_list arguments) {
    std::array<char, 300> line{};
    std::vsnprintf(line.data(), line.size(), format, arguments);
    lastError() = line.data();
}

[[noreturn]] void refuseDamaged(const std::filesystem::path& path, std::string_view what) {
    const std::string said =
        lastError().empty() ? std::string("libtiff does not say why") : printable(lastError());
    refuse(path, fmt::format("{} cannot be read ({})", what, said), "get an intact copy of the file");
}

StoredType typeOf(const std::filesystem::path& path, int bits, int format) {
    if (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_INT && format != SAMPLEFORMAT_IEEEFP) {
        refuse(path,
               fmt::format("its values are neither whole numbers nor floats (sample format {})", format),
               "save it as whole numbers or floats");
    }
    const bool isFloat = format == SAMPLEFORMAT_IEEEFP;
    const bool isSigned = format == SAMPLEFORMAT_INT;
    switch (bits) {
    case 8:
        if (!isFloat) {
            return isSigned ? StoredType::Int8 : StoredType::UInt8;
        }
        break;
    case 16:
        if (!isFloat) {
            return isSigned ? StoredType::Int16 : StoredType::UInt16;
        }
        break;
    case 32:
        return isFloat ? StoredType::Float32 : isSigned ? StoredType::Int32 : StoredType::UInt32;
    case 64:
        return isFloat ? StoredType::Float64 : isSigned ? StoredType::Int64 : StoredType::UInt64;
    default:
        break;
    }
    refuse(path, fmt::format("its pixels have {} bits of {}", bits, isFloat ? "a float" : "a whole number"),
           "whole numbers of 8, 16, 32 and 64 bits and floats of 32 and 64 can be read");
}

// Turns values of which 0 is white the other way round.
void setRight(const TiffPage& page, std::span<std::byte> values) {
    if (page.isInverted) {
        for (std::byte& part : values) { // the greatest number less a value is its bits turned over
            part = ~part;
        }
    }
}

} // namespace

void TiffFile::Close::operator()(tiff* file) const { TIFFClose(file); }

TiffFile::TiffFile(const std::filesystem::path& path) : path_(path) {
    TIFFSetWarningHandler(nullptr);
    TIFFSetErrorHandler(noteError);
    lastError().clear();
    file_.reset(
        TIFFOpen(path.c_str(), "rm")); // m: not mapped, so that a file that is cut meanwhile is an error
    if (!file_) {
        refuseDamaged(path, "it");
    }
}

std::int64_t TiffFile::pages() {
    if (pages_ >= 0) {
        return pages_;
    }
    pages_ = 0;
    bool isBehind = false; // the small ones come behind the whole ones
    for (std::int64_t number = 1;; ++number) {
        std::uint32_t kind = 0;
        TIFFGetFieldDefaulted(file_.get(), TIFFTAG_SUBFILETYPE, &kind);
        const bool isWhole = (kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0;
        if (isWhole && isBehind) {
            refuse(path_, "small and whole pictures take turns in it", "save it with whole pictures only");
        }
        isBehind = !isWhole;
        pages_ += isWhole ? 1 : 0;
        if (TIFFLastDirectory(file_.get()) != 0) {
            break;
        }
        if (number == std::numeric_limits<tdir_t>::max() || TIFFReadDirectory(file_.get()) == 0) {
            refuseDamaged(path_, fmt::format("what follows page {}", number));
        }
    }
    at_ = -1;
    if (pages_ == 0) {
        refuse(path_, "it has no picture", "get an intact copy of the file");
    }
    return pages_;
}

bool TiffFile::isSinglePage() {
    go(0);
    return TIFFLastDirectory(file_.get()) != 0;
}

void TiffFile::go(std::int64_t number) {
    if (at_ == number) {
        return;
    }
    lastError().clear();
    const bool isThere = at_ >= 0 && number == at_ + 1 ? TIFFReadDirectory(file_.get()) != 0
                                                       : TIFFSetDirectory(file_.get(), tdir_t(number)) != 0;
    at_ = isThere ? number : -1;
    if (!isThere) {
        refuseDamaged(path_, fmt::format("page {}", number + 1));
    }
}

TiffPage TiffFile::page(std::int64_t number) {
    go(number);
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint16_t bits = 1;
    std::uint16_t samples = 1;
    std::uint16_t format = SAMPLEFORMAT_UINT;
    std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
    TIFFGetField(file_.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(file_.get(), TIFFTAG_IMAGELENGTH, &height);
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_BITSPERSAMPLE, &bits);
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_SAMPLEFORMAT, &format);
    TIFFGetField(file_.get(), TIFFTAG_PHOTOMETRIC, &photometric);
    if (samples != 1 || photometric == PHOTOMETRIC_PALETTE) {
        refuse(path_, "its pixels are colours", "save it with one value a pixel, each channel by itself");
    }
    std::uint16_t compression = COMPRESSION_NONE;
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_COMPRESSION, &compression);
    if (compression ==
        COMPRESSION_JBIG) { // of black and white only; JBIG-KIT, which libtiff links, is never called
        refuse(path_, "its pixels are black or white", "save it with whole numbers of 8 bits or more");
    }
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_ORIENTATION, &orientation);
    if (orientation != ORIENTATION_TOPLEFT) {
        refuse(path_, fmt::format("its rows do not begin at the top left (orientation {})", orientation),
               "save it upright, so that left and right are not mistaken");
    }
    if (width == 0 || height == 0) {
        refuse(path_, fmt::format("page {} has no pixels", number + 1), "get an intact copy of the file");
    }
    const StoredType type = typeOf(path_, bits, format);
    const bool isInverted = photometric == PHOTOMETRIC_MINISWHITE;
    if (isInverted && type != StoredType::UInt8 && type != StoredType::UInt16) {
        refuse(path_, "its greatest values mean black", "save it with the greatest values as white");
    }
    return {width, height, type, isInverted};
}

void TiffFile::read(std::int64_t number, std::span<std::byte> values) {
    const TiffPage page = this->page(number);
    if (values.size() != page.bytes()) {
        throw Error("{}: page {} changed while it was read", path_.string(), number + 1);
    }
    lastError().clear();
    if (TIFFIsTiled(file_.get()) == 0) {
        readStrips(number, page, values);
    } else {
        readTiles(number, page, values);
    }
    setRight(page, values);
}

void TiffFile::readStrips(std::int64_t number, const TiffPage& page, std::span<std::byte> values) {
    std::uint32_t rows = 0;
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_ROWSPERSTRIP, &rows);
    const auto rowsOfStrip = std::min<std::int64_t>(std::max<std::uint32_t>(rows, 1), page.height);
    const std::size_t stripBytes = std::size_t(rowsOfStrip) * page.rowBytes();
    for (std::uint32_t strip = 0; !values.empty(); ++strip) {
        const std::size_t wanted = std::min(stripBytes, values.size());
        if (TIFFReadEncodedStrip(file_.get(), strip, values.data(), tmsize_t(wanted)) != tmsize_t(wanted)) {
            refuseDamaged(path_, fmt::format("page {}", number + 1));
        }
        values = values.subspan(wanted);
    }
}

void TiffFile::readTiles(std::int64_t number, const TiffPage& page, std::span<std::byte> values) {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    TIFFGetField(file_.get(), TIFFTAG_TILEWIDTH, &width);
    TIFFGetField(file_.get(), TIFFTAG_TILELENGTH, &height);
    constexpr std::uint64_t most = std::uint64_t(1) << 30;
    const auto bytes = std::uint64_t(TIFFTileSize64(file_.get()));
    if (width == 0 || height == 0 || bytes > most) {
        refuse(path_, fmt::format("page {} has tiles of {} x {}", number + 1, width, height),
               "get an intact copy of the file");
    }
    std::vector<std::byte> tile(bytes);
    const std::size_t tileRow = std::size_t(width) * bytesOf(page.type);
    for (std::int64_t y = 0; y < page.height; y += height) {
        for (std::int64_t x = 0; x < page.width; x += width) {
            if (TIFFReadTile(file_.get(), tile.data(), std::uint32_t(x), std::uint32_t(y), 0, 0) < 0) {
                refuseDamaged(path_, fmt::format("page {}", number + 1));
            }
            const std::int64_t rows = std::min<std::int64_t>(height, page.height - y);
            const std::size_t taken =
                std::size_t(std::min<std::int64_t>(width, page.width - x)) * bytesOf(page.type);
            std::byte* to =
                values.data() + std::size_t(y) * page.rowBytes() + std::size_t(x) * bytesOf(page.type);
            for (std::int64_t row = 0; row < rows; ++row, to += page.rowBytes()) {
                std::memcpy(to, tile.data() + std::size_t(row) * tileRow, taken);
            }
        }
    }
}

std::string TiffFile::description() {
    go(0);
    const char* text = nullptr;
    constexpr std::size_t most = std::size_t(1) << 20;
    return TIFFGetField(file_.get(), TIFFTAG_IMAGEDESCRIPTION, &text) != 0 && text != nullptr
               ? std::string(text, strnlen(text, most))
               : std::string();
}

glm::dvec2 TiffFile::resolution() {
    go(0);
    float x = 0;
    float y = 0;
    TIFFGetField(file_.get(), TIFFTAG_XRESOLUTION, &x);
    TIFFGetField(file_.get(), TIFFTAG_YRESOLUTION, &y);
    return {x, y};
}

bool TiffFile::isPerCentimetre() {
    go(0);
    std::uint16_t unit = RESUNIT_NONE;
    TIFFGetField(file_.get(), TIFFTAG_RESOLUTIONUNIT, &unit);
    return unit == RESUNIT_CENTIMETER;
}

std::uint64_t TiffFile::plainOffset() {
    const TiffPage first = page(0);
    std::uint16_t compression = COMPRESSION_NONE;
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_COMPRESSION, &compression);
    const std::uint64_t* offsets = nullptr;
    if (compression != COMPRESSION_NONE || TIFFIsTiled(file_.get()) != 0 ||
        TIFFGetField(file_.get(), TIFFTAG_STRIPOFFSETS, &offsets) == 0 || offsets == nullptr) {
        return 0;
    }
    const std::uint32_t strips = TIFFNumberOfStrips(file_.get());
    std::uint32_t rows = 0;
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_ROWSPERSTRIP, &rows);
    const std::uint64_t stripBytes = std::uint64_t(rows) * std::uint64_t(first.width) * bytesOf(first.type);
    for (std::uint32_t strip = 1; strip < strips; ++strip) {
        if (offsets[strip] != offsets[0] + strip * stripBytes) {
            return 0;
        }
    }
    return offsets[0];
}

void TiffFile::readPlain(std::uint64_t offset, std::span<std::byte> values) {
    const TiffPage page = this->page(0);
    std::ifstream stream(path_, std::ios::binary);
    stream.seekg(std::streamoff(offset));
    if (!stream.read(reinterpret_cast<char*>(values.data()), std::streamsize(values.size()))) {
        refuse(path_, "it cannot be read to its end", "check the disk and the permissions");
    }
    const std::size_t valueBytes = bytesOf(page.type);
    if (TIFFIsByteSwapped(file_.get()) != 0) {
        for (auto value = values.begin(); value != values.end(); value += std::ptrdiff_t(valueBytes)) {
            std::reverse(value, value + std::ptrdiff_t(valueBytes));
        }
    }
    setRight(page, values);
}

} // namespace vs::volume

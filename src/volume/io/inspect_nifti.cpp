// SPDX-License-Identifier: Apache-2.0
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

namespace vs::volume {
namespace {

constexpr std::size_t headerBytes = 348;

// The fields of a NIfTI-1 header that decide what is read, in the machine's byte order.
class Header {
public:
    Header(std::vector<unsigned char> bytes, bool swapped) : bytes_(std::move(bytes)), swapped_(swapped) {}

    [[nodiscard]] std::int16_t dim(std::size_t i) const { return get<std::int16_t>(40 + 2 * i); }
    [[nodiscard]] int datatype() const { return get<std::int16_t>(70); }
    [[nodiscard]] int bitpix() const { return get<std::int16_t>(72); }
    [[nodiscard]] float pixdim(std::size_t i) const { return get<float>(76 + 4 * i); }
    [[nodiscard]] float voxOffset() const { return get<float>(108); }
    [[nodiscard]] float slope() const { return get<float>(112); }
    [[nodiscard]] float intercept() const { return get<float>(116); }
    [[nodiscard]] bool hasForm() const { return get<std::int16_t>(252) > 0 || get<std::int16_t>(254) > 0; }
    [[nodiscard]] bool hasSform() const { return get<std::int16_t>(254) > 0; }
    // Quaternion and offset of the qform (256..279), rows of the sform (280..327).
    [[nodiscard]] bool formsAreFinite() const {
        for (std::size_t at = 256; at < (hasSform() ? 328U : 280U); at += 4) {
            if (!std::isfinite(get<float>(at))) {
                return false;
            }
        }
        return true;
    }
    // Rows of the sform, from its RAS millimetres to LPS.
    [[nodiscard]] glm::dmat4 sform() const {
        glm::dmat4 matrix(1.0);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                const double value = get<float>(280 + 16 * std::size_t(row) + 4 * std::size_t(column));
                matrix[column][row] = row < 2 ? -value : value;
            }
        }
        return matrix;
    }
    [[nodiscard]] bool isSwapped() const { return swapped_; }
    [[nodiscard]] std::string magic() const {
        return std::string(reinterpret_cast<const char*>(bytes_.data()) + 344, 3);
    }

private:
    template <typename T>
    [[nodiscard]] T get(std::size_t at) const {
        std::array<unsigned char, sizeof(T)> raw;
        std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), sizeof(T), raw.begin());
        if (swapped_) {
            std::reverse(raw.begin(), raw.end());
        }
        T value;
        std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }

    std::vector<unsigned char> bytes_;
    bool swapped_;
};

Header readHeader(const std::filesystem::path& path, bool gzipped) {
    auto bytes = readPrefix(path, headerBytes, gzipped);
    if (bytes.size() < headerBytes) {
        refuse(path, fmt::format("its header has {} bytes", bytes.size()), "a NIfTI header has 348");
    }
    std::int32_t size = 0;
    std::memcpy(&size, bytes.data(), 4);
    const auto is = [&](std::int32_t value) {
        return size == value || size == std::int32_t(__builtin_bswap32(std::uint32_t(value)));
    };
    if (is(540)) {
        refuse(path, "it is a NIfTI-2 file", "save it as NIfTI-1");
    }
    if (!is(std::int32_t(headerBytes))) {
        refuse(path, fmt::format("the header's size field says {}", size), "a NIfTI file starts with 348");
    }
    Header header(std::move(bytes), size != std::int32_t(headerBytes));
    if (header.magic() != "n+1" && header.magic() != "ni1") {
        refuse(path, fmt::format("the NIfTI mark is \"{}\"", printable(trimmed(header.magic()))),
               "it must be \"n+1\" or \"ni1\" (Analyze files hold no orientation: convert them to NIfTI)");
    }
    return header;
}

// Bytes per voxel of the scalar types.
std::uint64_t voxelBytes(const std::filesystem::path& path, const Header& header,
                         std::vector<std::string>& notices) {
    struct Type {
        int code;
        std::uint64_t bytes;
    };
    constexpr Type scalars[] = {{2, 1},   {4, 2},   {8, 4},   {16, 4},   {64, 8},
                                {256, 1}, {512, 2}, {768, 4}, {1024, 8}, {1280, 8}};
    for (const auto& type : scalars) {
        if (type.code == header.datatype()) {
            if (header.bitpix() != int(8 * type.bytes)) {
                notices.push_back(
                    fmt::format("{}: the header says {} bits per voxel, its data type has {}; the type "
                                "was believed",
                                path.string(), header.bitpix(), 8 * type.bytes));
            }
            return type.bytes;
        }
    }
    const int code = header.datatype();
    const char* what = code == 32 || code == 1792 || code == 2048 ? "complex values"
                       : code == 128 || code == 2304              ? "colours"
                       : code == 1536                             ? "128-bit floating point values"
                       : code == 1                                ? "single bits"
                                                                  : "an unknown data type";
    refuse(path, fmt::format("it holds {} (data type {})", what, code),
           "one real number per voxel is needed: integers of 8 to 64 bits or floats of 32 or 64");
}

std::vector<std::int64_t> volumeSizes(const std::filesystem::path& path, const Header& header) {
    const int dimensions = header.dim(0);
    if (dimensions < 3 || dimensions > 7) {
        refuse(path, fmt::format("it has {} dimensions", dimensions), "a volume has 3, or 4 with --frame");
    }
    std::vector<std::int64_t> sizes;
    for (std::size_t i = 1; i <= std::size_t(dimensions); ++i) {
        sizes.push_back(header.dim(i));
    }
    for (std::size_t i = 4; i < sizes.size(); ++i) {
        if (sizes[i] > 1) {
            refuse(path, fmt::format("it has {} values per voxel or more than 4 dimensions", sizes[i]),
                   "one number per voxel is needed");
        }
    }
    if (sizes.size() > 4) {
        (void)checkedBytes(path, sizes, 1); // the unused sizes too must be sane before they are dropped
        sizes.resize(4);
    }
    return sizes;
}

std::filesystem::path dataFile(const std::filesystem::path& path, const Header& header) {
    if (header.magic() == "n+1") {
        return path;
    }
    auto stem = path.filename();
    if (stem.extension() == ".gz") {
        stem = stem.stem();
    }
    const auto name = stem.replace_extension(".img").string();
    std::error_code error;
    const bool plain = std::filesystem::exists(path.parent_path() / name, error);
    return siblingFile(path, plain ? name : name + ".gz");
}

void checkPlace(const std::filesystem::path& path, const Header& header) {
    for (std::size_t i = 1; i <= 3; ++i) {
        checkSpacing(path, header.pixdim(i));
    }
    if (header.hasForm() && !header.formsAreFinite()) {
        refuse(path, "its orientation (qform or sform) holds values that are not numbers",
               "they must be finite");
    }
}

// A slope of zero means none; so do values that are not numbers, which some programs write for "not set".
void takeScaling(const std::filesystem::path& path, const Header& header, NiftiInspection& inspection) {
    if (!std::isfinite(header.slope()) || !std::isfinite(header.intercept())) {
        inspection.notices.push_back(fmt::format(
            "{}: the scale slope or intercept is not a number; values are unscaled", path.string()));
    } else if (header.slope() != 0) {
        inspection.slope = header.slope();
        inspection.intercept = header.intercept();
    }
}

} // namespace

NiftiInspection inspectNifti(const std::filesystem::path& path) {
    const bool gzipped = hasGzipMagic(path);
    const bool namedGz = lowerCase(path.extension().string()) == ".gz";
    if (gzipped != namedGz) {
        refuse(path,
               gzipped ? "it is gzip-compressed but not named so"
                       : "it is named .gz but is not gzip-compressed",
               gzipped ? "name it .nii.gz" : "name it .nii");
    }
    const Header header = readHeader(path, gzipped);
    NiftiInspection inspection;
    inspection.sizes = volumeSizes(path, header);
    const std::uint64_t bytes =
        checkedBytes(path, inspection.sizes, voxelBytes(path, header, inspection.notices));
    checkPlace(path, header);
    takeScaling(path, header, inspection);

    const float offset = header.voxOffset();
    const auto file = dataFile(path, header);
    const float least = file == path ? float(headerBytes) : 0.0F;
    if (!std::isfinite(offset) || offset < least || offset > 1e9F) {
        refuse(path, fmt::format("its values should start at byte {}", offset),
               fmt::format("they start at {} or later", least));
    }
    const auto start = std::uint64_t(offset);
    DataBlock& block = inspection.block;
    block = {.file = file, .offset = start, .encoding = Encoding::Raw, .expected = bytes};
    if (hasGzipMagic(file)) {
        inspection.valuesAt = start;
        block = {.file = file, .offset = 0, .encoding = Encoding::Deflated, .expected = bytes + start};
    }
    checkDataBlock(path, block, inspection.notices);
    inspection.datatype = header.datatype();
    inspection.swapped = header.isSwapped();
    if (header.hasSform()) {
        inspection.sform = header.sform();
    }
    return inspection;
}

} // namespace vs::volume

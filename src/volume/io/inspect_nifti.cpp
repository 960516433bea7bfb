// SPDX-License-Identifier: Apache-2.0
#include "volume/io/inspect.h"

#include <fmt/format.h>
#include <nifti1_io.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

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
    [[nodiscard]] bool hasQform() const { return get<std::int16_t>(252) > 0; }
    [[nodiscard]] bool hasSform() const { return get<std::int16_t>(254) > 0; }
    // Quaternion and offset of the qform (256..279), rows of the sform (280..327).
    [[nodiscard]] bool formsAreSane() const {
        for (std::size_t at = hasQform() ? 256 : 280; at < (hasSform() ? 328U : 280U); at += 4) {
            if (!(std::abs(double(get<float>(at))) < 1e6 / unitsInMm())) {
                return false;
            }
        }
        return true;
    }
    // What its lengths are in, of mm; mm where it does not say.
    [[nodiscard]] double unitsInMm() const {
        const int units = bytes_[123] & 7;
        return units == 1 ? 1000 : units == 3 ? 0.001 : 1;
    }
    // Where voxels lie by either form, LPS mm.
    [[nodiscard]] glm::dmat4 sform() const {
        mat44 rows{};
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 4; ++column) {
                rows.m[row][column] = get<float>(280 + 16 * row + 4 * column);
            }
        }
        return inLpsMm(rows);
    }
    [[nodiscard]] glm::dmat4 qform() const {
        return inLpsMm(nifti_quatern_to_mat44(get<float>(256), get<float>(260), get<float>(264),
                                              get<float>(268), get<float>(272), get<float>(276), pixdim(1),
                                              pixdim(2), pixdim(3), pixdim(0) < 0 ? -1.0F : 1.0F));
    }
    [[nodiscard]] bool isSwapped() const { return swapped_; }
    [[nodiscard]] std::string magic() const {
        return std::string(reinterpret_cast<const char*>(bytes_.data()) + 344, 3);
    }

private:
    // From rows of RAS in the file's unit.
    [[nodiscard]] glm::dmat4 inLpsMm(const mat44& rows) const {
        glm::dmat4 matrix(1.0);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                const double value = rows.m[row][column];
                matrix[column][row] = unitsInMm() * (row < 2 ? -value : value);
            }
        }
        return matrix;
    }
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
    auto bytes = gzipped ? inflatedPrefix(path, headerBytes) : readPrefix(path, headerBytes);
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

StoredType storedType(const std::filesystem::path& path, const Header& header,
                      std::vector<std::string>& notices) {
    constexpr std::array<std::pair<int, StoredType>, 10> scalars{{{2, StoredType::UInt8},
                                                                  {4, StoredType::Int16},
                                                                  {8, StoredType::Int32},
                                                                  {16, StoredType::Float32},
                                                                  {64, StoredType::Float64},
                                                                  {256, StoredType::Int8},
                                                                  {512, StoredType::UInt16},
                                                                  {768, StoredType::UInt32},
                                                                  {1024, StoredType::Int64},
                                                                  {1280, StoredType::UInt64}}};
    for (const auto& [code, type] : scalars) {
        if (code == header.datatype()) {
            const int bits = int(8 * bytesOf(type));
            if (header.bitpix() != bits) {
                notices.push_back(
                    fmt::format("{}: the header says {} bits per voxel, its data type has {}; the type "
                                "was believed",
                                path.string(), header.bitpix(), bits));
            }
            return type;
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
        checkSpacing(path, header.pixdim(i) * header.unitsInMm());
    }
    if (!header.formsAreSane()) {
        refuse(path, "its orientation (qform or sform) holds values that are not numbers, or no millimetres",
               "they must be finite and below a million");
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

// How far apart two places of a grid put the same voxel at most, in mm.
double farthestApart(const glm::dmat4& a, const glm::dmat4& b, const glm::ivec3& dims) {
    double most = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 voxel((corner & 1) * (dims.x - 1), (corner >> 1 & 1) * (dims.y - 1),
                               (corner >> 2) * (dims.z - 1), 1);
        most = std::max(most, glm::length(glm::dvec3(a * voxel - b * voxel)));
    }
    return most;
}

// By the sform where there is one, as other programs do: it holds any grid. A file that says nothing of its
// place has axes that run to the left, backwards and up, from the origin.
GridGeometry placeOf(const std::filesystem::path& path, const Header& header, const glm::ivec3& dims,
                     std::vector<std::string>& notices) {
    GridGeometry geometry;
    geometry.dims = dims;
    if (!header.hasSform() && !header.hasQform()) {
        for (int axis = 0; axis < 3; ++axis) {
            geometry.worldFromVoxel[axis][axis] = header.unitsInMm() * header.pixdim(std::size_t(axis) + 1);
        }
        return geometry;
    }
    geometry.worldFromVoxel = header.hasSform() ? header.sform() : header.qform();
    if (geometry.isSheared()) {
        notices.push_back(
            fmt::format("{}: its axes are not perpendicular; the sform was used as it is", path.string()));
    }
    if (header.hasSform() && header.hasQform()) {
        const double apart = farthestApart(header.sform(), header.qform(), dims);
        if (apart > 0.5 * geometry.stepMm()) {
            notices.push_back(
                fmt::format("{}: its two orientations differ by up to {:.3g} mm; the sform was used, "
                            "not the qform",
                            path.string(), apart));
        }
    }
    return geometry;
}

} // namespace

NiftiInspection inspectNifti(const std::filesystem::path& path, Inflated inflated) {
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
    const StoredType type = storedType(path, header, inspection.notices);
    const std::uint64_t bytes = checkedBytes(path, inspection.sizes, bytesOf(type));
    checkPlace(path, header);
    takeScaling(path, header, inspection);

    const float offset = header.voxOffset();
    const auto file = dataFile(path, header);
    const float least = file == path ? float(headerBytes) : 0.0F;
    constexpr float most = 1 << 26; // extensions behind headers hold texts
    if (!(offset >= least && offset <= most)) {
        refuse(path, fmt::format("its values should start at byte {}", offset),
               fmt::format("they start at {} to {}", least, most));
    }
    const auto start = std::uint64_t(offset);
    inspection.block = {.file = file,
                        .offset = start,
                        .type = type,
                        .isBigEndian = header.isSwapped() != (std::endian::native == std::endian::big),
                        .count = bytes / bytesOf(type)};
    if (hasGzipMagic(file)) {
        inspection.block.offset = 0;
        inspection.block.encoding = Encoding::Deflated;
        inspection.block.before = start;
    }
    checkDataBlock(path, inspection.block, inspection.notices, keptOf(inspection, inflated));
    inspection.geometry = placeOf(path, header, inspection.dims(), inspection.notices);
    return inspection;
}

} // namespace vs::volume

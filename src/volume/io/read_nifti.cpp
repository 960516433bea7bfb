// SPDX-License-Identifier: Apache-2.0
// ITK says where a NIfTI volume lies; the values are read here, because the library behind ITK's reader
// silently turns NaN and infinite values into zeros, and because one volume of a 4D file can then be read
// alone.
#include "volume/io/formats.h"
#include "volume/io/inspect.h"
#include "volume/io/itk_decode.h"

#include <fmt/format.h>
#include <itkNiftiImageIO.h>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace vs::volume {
namespace {

itk::IOComponentEnum componentOf(int datatype) {
    using enum itk::CommonEnums::IOComponent;
    switch (datatype) {
    case 2:
        return UCHAR;
    case 4:
        return SHORT;
    case 8:
        return INT;
    case 16:
        return FLOAT;
    case 64:
        return DOUBLE;
    case 256:
        return CHAR;
    case 512:
        return USHORT;
    case 768:
        return UINT;
    case 1024:
        return LONGLONG;
    case 1280:
        return ULONGLONG;
    default:
        throw std::runtime_error("a data type that is not read here");
    }
}

void swapBytes(std::vector<std::byte>& bytes, std::size_t width) {
    for (std::size_t i = 0; width > 1 && i < bytes.size(); i += width) {
        std::reverse(bytes.data() + i, bytes.data() + i + width);
    }
}

// Replaces stored values by slope * value + intercept as 32-bit floats.
void rescale(Volume& volume, double slope, double intercept) {
    const std::size_t count = volume.bytes.size() / sizeOf(volume.type);
    std::vector<std::byte> scaled(count * sizeof(float));
    visit(volume, [&](const auto* values) {
        auto* out = reinterpret_cast<float*>(scaled.data());
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = static_cast<float>(slope * double(values[i]) + intercept);
        }
    });
    volume.type = ScalarType::Float32;
    volume.bytes = std::move(scaled);
}

GridGeometry readGeometry(const std::filesystem::path& path, const NiftiInspection& inspection,
                          std::vector<std::string>& notices) {
    try {
        const QuietLibraries quiet;
        const auto io = itk::NiftiImageIO::New();
        io->SetFileName(path.string());
        io->ReadImageInformation();
        const auto geometry = geometryOf(*io);
        for (int axis = 0; axis < 3; ++axis) {
            if (geometry.dims[axis] != inspection.sizes[std::size_t(axis)]) {
                throw std::runtime_error("the header is ambiguous");
            }
        }
        return geometry;
    } catch (const itk::ExceptionObject&) {
        // ITK wants perpendicular axes, to more digits than many programs write. A grid here may have any.
        if (!inspection.sform) {
            throw;
        }
    }
    GridGeometry geometry;
    geometry.dims = {int(inspection.sizes[0]), int(inspection.sizes[1]), int(inspection.sizes[2])};
    geometry.worldFromVoxel = *inspection.sform;
    notices.push_back(fmt::format("{}: its axes are not exactly perpendicular; the sform was used as it is",
                                  path.string()));
    return geometry;
}

} // namespace

ReadResult readNifti(const std::filesystem::path& path, const ReadOptions& options) {
    NiftiInspection inspection = inspectNifti(path);
    const std::int64_t frames = inspection.sizes.size() > 3 ? inspection.sizes[3] : 1;
    const int frame = chosenFrame(path, frames, options.frame);
    ReadResult result;
    result.notices = std::move(inspection.notices);
    Volume& volume = result.volume;
    volume.geometry = readGeometry(path, inspection, result.notices);

    const std::uint64_t frameBytes =
        (inspection.block.expected - inspection.valuesAt) / std::uint64_t(frames);
    std::vector<std::byte> bytes(frameBytes);
    readBlock(inspection.block, inspection.valuesAt + frameBytes * std::uint64_t(frame), bytes);
    if (inspection.swapped) {
        swapBytes(bytes, frameBytes / volume.geometry.voxelCount());
    }
    if (takeValues(volume, componentOf(inspection.datatype), std::move(bytes))) {
        result.notices.push_back(
            fmt::format("{}: 64-bit values were rounded to 32-bit floats; some changed", path.string()));
    }
    volume.details.format = "NIfTI";
    volume.details.slope = inspection.slope;
    volume.details.intercept = inspection.intercept;
    volume.details.frame = frame;
    volume.details.frames = int(frames);
    // As ITK does: factors that change nothing leave the type alone.
    constexpr double nothing = std::numeric_limits<float>::epsilon();
    if (std::abs(inspection.slope - 1) > nothing || std::abs(inspection.intercept) > nothing) {
        rescale(volume, inspection.slope, inspection.intercept);
    }
    return result;
}

} // namespace vs::volume

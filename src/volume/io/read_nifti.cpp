// SPDX-License-Identifier: Apache-2.0
// ITK says where a NIfTI volume lies, but where its axes are not perpendicular.
#include "volume/io/formats.h"
#include "volume/io/inspect.h"
#include "volume/io/itk_decode.h"

#include <fmt/format.h>
#include <itkNiftiImageIO.h>

#include <limits>
#include <type_traits>

namespace vs::volume {
namespace {

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
    NiftiInspection inspection = inspectNifti(path, Inflated::Kept);
    const std::int64_t frames = inspection.sizes.size() > 3 ? inspection.sizes[3] : 1;
    const int frame = chosenFrame(path, frames, options.frame);
    ReadResult result;
    result.notices = inspection.notices;
    Volume& volume = result.volume;
    volume.geometry = readGeometry(path, inspection, result.notices);

    takeFrame(path, inspection, frame, result);
    volume.details.format = "NIfTI";
    volume.details.slope = inspection.slope;
    volume.details.intercept = inspection.intercept;
    // As ITK does: factors that change nothing leave the type alone.
    constexpr double nothing = std::numeric_limits<float>::epsilon();
    if (std::abs(inspection.slope - 1) > nothing || std::abs(inspection.intercept) > nothing) {
        rescale(volume, inspection.slope, inspection.intercept);
    }
    return result;
}

} // namespace vs::volume

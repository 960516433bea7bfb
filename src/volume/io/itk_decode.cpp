// SPDX-License-Identifier: Apache-2.0
#include "volume/io/itk_decode.h"

#include "volume/io/quiet_libraries.h"
#include "volume/io/take_values.h"

#include <fmt/format.h>

#include <cmath>

namespace vs::volume {
GridGeometry geometryOf(const itk::ImageIOBase& io) {
    GridGeometry geometry;
    for (unsigned axis = 0; axis < 3; ++axis) {
        geometry.dims[int(axis)] = int(io.GetDimensions(axis));
        const auto direction = io.GetDirection(axis);
        for (unsigned row = 0; row < 3; ++row) {
            geometry.worldFromVoxel[int(axis)][int(row)] = direction[row] * io.GetSpacing(axis);
        }
        geometry.worldFromVoxel[3][int(axis)] = io.GetOrigin(axis);
    }
    return geometry;
}

ReadResult readPlacedByItk(itk::ImageIOBase& io, const std::filesystem::path& path, Inspection&& inspection,
                           std::optional<int> frame) {
    const std::int64_t frames = inspection.sizes.size() > 3 ? inspection.sizes[3] : 1;
    const int picked = chosenFrame(path, frames, frame);
    ReadResult result;
    result.notices = inspection.notices;
    try {
        const QuietLibraries quiet;
        io.SetFileName(path.string());
        io.ReadImageInformation();
        // What ITK has understood must be what was inspected.
        bool isSame = io.GetNumberOfDimensions() >= 3;
        for (unsigned axis = 0; axis < 3; ++axis) {
            isSame = isSame && io.GetDimensions(axis) == std::uint64_t(inspection.sizes[axis]);
        }
        if (!isSame) {
            throw std::runtime_error("the header is ambiguous");
        }
        result.volume.geometry = geometryOf(io);
        takeFrame(path, inspection, picked, result);
    } catch (const std::bad_alloc&) {
        refuse(path, "it does not fit into memory", "crop it or use a machine with more");
    } catch (const std::exception& error) {
        refuse(path, fmt::format("it cannot be read ({})", shortReason(error)),
               "check the header and the data");
    }
    return result;
}

} // namespace vs::volume

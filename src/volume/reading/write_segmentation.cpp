// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/write_segmentation.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "volume/reading/decoder_process.h"

#include <algorithm>

namespace vs::volume {

int writeDicomSegmentation(const std::filesystem::path& path, const SegmentationOrder& order,
                           std::span<const std::uint8_t> labels) {
    if (order.geometry.isSheared()) {
        throw WriteError("{}: DICOM cannot hold this grid, whose axes are not perpendicular; write .nrrd",
                         path.string());
    }
    if (std::max(order.geometry.dims.x, order.geometry.dims.y) > 65535) {
        throw WriteError("{}: DICOM holds at most 65535 voxels along an axis; write .nrrd", path.string());
    }
    outputFile(path); // what cannot be written is refused before the work
    DecoderProcess decoder(SegmentationRequest{order}, std::as_bytes(labels));
    const auto made = decoder.finalAnswer<MadeSegmentation>(path);
    std::vector<std::byte> file;
    try {
        file = decoder.content(made.bytes);
    } catch (const Error& error) {
        throw WriteError("{}: its decoder gave {}; try it again", path.string(), error.what());
    }
    writeFileAtomically(path, file);
    return made.sources;
}

} // namespace vs::volume

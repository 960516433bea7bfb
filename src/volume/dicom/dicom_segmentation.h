// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vs::volume {

// One segment of a DICOM segmentation.
struct DicomSegment {
    std::uint8_t label = 1; // in the label map
    std::string name;
    glm::dvec3 colour{0.8}; // sRGB, 0 to 1
};

// The files of a DICOM series that readVolume() would assemble from this path, in the order of the grid's
// slices; empty when the path is not DICOM. Throws as readVolume() does.
std::vector<std::filesystem::path> dicomFilesOf(const std::filesystem::path& path,
                                                const ReadOptions& options);

// Writes segments as a DICOM Segmentation object (binary; a frame for each slice of each segment that has
// voxels) by DCMTK. With `sources`, the files of the series that the grid was read from, patient, study and
// frame of reference are theirs, and each frame names the slice that it lies on; without, identifiers are
// made up and the patient's are empty. The property of every segment is "Tissue": nothing else is known.
// Atomic. Throws WriteError naming the file, also when the grid's axes are not perpendicular.
void writeDicomSegmentation(const std::filesystem::path& path, const GridGeometry& geometry,
                            std::span<const std::uint8_t> labels, std::span<const DicomSegment> segments,
                            std::span<const std::filesystem::path> sources = {});

} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
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

// The files of a DICOM series that decodeVolume() would assemble from this path, in the order of the grid's
// slices; empty when the path is not DICOM. Throws as decodeVolume() does.
std::vector<std::filesystem::path> dicomFilesOf(const std::filesystem::path& path,
                                                const ReadOptions& options);

// What a DICOM Segmentation object is made of, beside the labels.
struct SegmentationOrder {
    GridGeometry geometry;
    std::vector<DicomSegment> segments;
    std::filesystem::path source; // what the grid was read from; empty: nothing that counts
    ReadOptions reading;          // how
};

// Makes a DICOM Segmentation object (binary; a frame for each slice of each segment that has voxels) by DCMTK
// and gives `take` the bytes of its file, piece by piece. Where the source is a DICOM series, patient, study
// and frame of reference are its, and each frame names the slice that it lies on; without, identifiers are
// made up and the patient's are empty. The property of every segment is "Tissue": nothing else is known.
// Returns how many files the series has. For the decoder (volume/reading/write_segmentation.h is for others),
// since DCMTK reads the headers of strangers' files.
int makeDicomSegmentation(const SegmentationOrder& order, std::span<const std::uint8_t> labels,
                          const std::function<void(std::span<const std::byte>)>& take);

} // namespace vs::volume

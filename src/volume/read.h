// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/volume.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vs::volume {

// Layout of a headerless file, as written on the command line: DIMS:TYPE[:SPACING[:OFFSET]], for example
// "256x256x108:int16:0.957,0.957,1.5". Little endian, x fastest, first voxel's centre at the world's origin.
struct RawLayout {
    glm::ivec3 dims{0};
    ScalarType type = ScalarType::UInt8;
    glm::dvec3 spacing{1.0};
    std::size_t offsetBytes = 0;
};

// Throws UsageError if the text is not a layout, saying what one looks like.
RawLayout parseRawLayout(const std::string& text);

// Whether a file is of no known format, so that only a layout can tell what it holds.
bool isHeaderless(const std::filesystem::path& path);

struct ReadOptions {
    std::optional<RawLayout> raw; // set: the file is headerless and has this layout
    std::optional<std::string>
        series;               // which DICOM series of a folder: its UID or its number in the list of choices
    std::optional<int> frame; // which volume of a 4D file, counted from 0
};

struct ReadResult {
    Volume volume;
    std::vector<std::string> notices; // what was unusual and what was done about it, one line each
};

// Reads NIfTI, NRRD, MetaImage, VTK legacy, a DICOM folder (or any file of it) or a described raw file.
// Headers are inspected before anything is allocated. DICOM slices are placed by their positions; tilted,
// uneven or missing slices are resampled to a regular grid with a notice. Throws ReadError with one line
// naming the file, what is wrong and what would be right.
ReadResult readVolume(const std::filesystem::path& path, const ReadOptions& options = {});

} // namespace vs::volume

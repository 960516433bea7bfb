// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "volume/grid/volume.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
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

// Reads the text of a layout. Throws UsageError if it is none, saying what one looks like.
RawLayout parseRawLayout(const std::string& text);

// Whether a file is of no known format, so that only a layout can tell what it holds.
bool isHeaderless(const std::filesystem::path& path);

// So many slices of a stack.
struct Slices {
    int first = 0;
    int count = 0;
};

struct ReadOptions {
    std::optional<RawLayout> raw; // set: the file is headerless and has this layout
    std::optional<std::string>
        series;               // which DICOM series of a folder: its UID or its number in the list of choices
    std::optional<int> frame; // which volume of a 4D file, counted from 0
    std::optional<int> level; // of a store of OME-Zarr: 0 is the finest, which is read without
    std::optional<Slices> slices; // only these, of a stack of TIFF pictures
    std::optional<int> channel;   // of a store that has several
};

struct ReadResult {
    Volume volume;
    std::vector<std::string> notices; // what was unusual and what was done about it, one line each
    // Smallest and largest value of the finest level, where a coarser one was read and that is known: its
    // means never are as small and as great. They count in the volume's range.
    std::optional<Range> ofFinest = {};
};

// One DICOM series of a folder, for choosing: `series` of ReadOptions takes its number in the list, or its
// UID where no other has that too.
struct SeriesChoice {
    std::string uid;
    std::string description;                // as a person named it; may be empty
    std::string modality;                   // "CT", "MR" ...; may be empty
    glm::ivec2 size{0};                     // columns, rows
    std::optional<glm::dvec2> pixelSpacing; // mm between columns, between rows, where it is stated
    std::optional<double> sliceSpacing;     // mm
    int images = 0;
};

// A folder holds several DICOM series and none was chosen. The text lists them for the command line.
class SeveralSeries : public ReadError {
public:
    SeveralSeries(const std::string& message, std::vector<SeriesChoice> choices)
        : ReadError(message), choices_(std::move(choices)) {}
    [[nodiscard]] const std::vector<SeriesChoice>& choices() const { return choices_; }

private:
    std::vector<SeriesChoice> choices_;
};

} // namespace vs::volume

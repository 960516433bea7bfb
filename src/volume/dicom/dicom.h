// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "volume/io/read.h"

#include <optional>
#include <string>
#include <vector>

// DICOM: scanning, grouping and assembling. Internal to this folder.
namespace vs::volume {

// One image of a DICOM file: the file itself, or one frame of it.
struct DicomSlice {
    std::filesystem::path file;
    int frame = 0;
    int frameCount = 1;
    std::string instanceUid;
    std::string seriesUid;
    std::string description;
    glm::ivec2 size{0};                 // columns, rows
    std::optional<glm::dvec3> position; // LPS mm, centre of the first pixel
    glm::dvec3 alongColumns{1, 0, 0};   // direction in which the column index grows
    glm::dvec3 alongRows{0, 1, 0};      // direction in which the row index grows
    bool hasOrientation = false;
    std::optional<glm::dvec2> pixelSpacing; // mm between columns, between rows
    std::optional<double> sliceSpacing;     // mm between slices as stated, else their thickness
    std::optional<glm::dvec2> frameScale;   // slope and intercept that ITK does not know of
    glm::dvec2 scale{1, 0}; // slope and intercept of this slice, for telling whether they differ
    double timeOrder = 0;   // orders slices at the same position
    std::string photometric;
    std::string unit;    // of the values; empty where none is stated
    ScanDetails details; // of the series, and how this slice is scaled

    [[nodiscard]] glm::dvec3 normal() const { return glm::normalize(glm::cross(alongColumns, alongRows)); }
    [[nodiscard]] double offset() const { return position ? glm::dot(*position, normal()) : 0.0; }
};

// An intact image that cannot become part of a volume (colours, a mosaic, a segmentation).
class UnsuitableImage : public ReadError {
public:
    using ReadError::ReadError;
};

// What a file is to us. `slices` is empty when it holds no image; `reason` then says what it is.
struct DicomFile {
    std::vector<DicomSlice> slices;
    std::string reason;
    std::vector<std::string> notices;
};

bool hasDicomMark(const std::filesystem::path& path);

// Reads the header of a file that has the DICOM mark. Throws ReadError if it is damaged, UnsuitableImage if
// it cannot become part of a volume.
DicomFile scanDicomFile(const std::filesystem::path& path);

// Slices of one series with one orientation, size and spacing.
struct DicomGroup {
    std::vector<DicomSlice> slices;
    [[nodiscard]] std::string uid() const { return slices.front().seriesUid; }
};

std::vector<DicomGroup> groupSlices(std::vector<DicomSlice> slices);

// A stack of parallel slices of one size, sorted along the normal, with the positions from their headers.
struct SliceStack {
    Volume volume;                     // values; geometry.dims set, the rest of the geometry not yet
    std::vector<glm::dvec3> positions; // of the first pixel of each slice, LPS mm
    glm::dvec3 alongColumns{1, 0, 0};
    glm::dvec3 alongRows{0, 1, 0};
    glm::dvec2 pixelSpacing{1}; // mm between columns, between rows
    double sliceSpacing = 1;    // mm, for a stack of one slice
};

// Gives the stack a regular grid: as it is where the positions allow, else resampled linearly along the
// normal (uneven or missing slices) and within the plane (tilted gantry). Says in `notices` what was done.
void makeRegular(const std::filesystem::path& path, SliceStack& stack, std::vector<std::string>& notices);

} // namespace vs::volume

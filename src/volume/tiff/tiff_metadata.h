// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <cstdint>
#include <optional>
#include <string>

namespace vs::volume {

// What programs for microscopes write into the description of a TIFF stack's first page: ImageJ its lines of
// "key=value", others OME-XML (Open Microscopy Environment, model of 2016).
struct TiffMetadata {
    // How many pages there are along each; 0: nobody says.
    std::int64_t slices = 0;
    std::int64_t channels = 1;
    std::int64_t times = 1;
    std::string order = "CZT"; // of the pages, the fastest first
    glm::dvec3 spacingMm{0};   // 0: not said; z alone: how far apart slices are is not
    bool isImageJ = false;
    std::int64_t images = 0; // of ImageJ: pages, though the file may describe only the first

    // Which page holds a slice.
    [[nodiscard]] std::int64_t pageOf(std::int64_t slice, std::int64_t channel, std::int64_t time) const;
};

// `pixelsPerUnit` is the first page's resolution, in the units that ImageJ names, or in those that the file
// itself does.
TiffMetadata readTiffMetadata(const std::string& description, glm::dvec2 pixelsPerUnit, bool isPerCentimetre);

} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/geometry.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vs::cli {

// A label map as read from a file: each voxel holds the number of its label, counted from 1 in the order of
// the labels' values in the file; 0 is none.
struct LabelMap {
    std::filesystem::path path;
    volume::GridGeometry geometry;
    std::vector<std::uint8_t> labels;
    std::vector<std::int64_t> values; // by label; the first is 0
};

// Reads any format that volumes are read from and prints its notices. Throws ReadError, also for values that
// are no whole numbers and for more than 255 different ones.
LabelMap readLabelMap(const std::filesystem::path& path);

// Throws Error if the label map's grid is not that of the volume: other dimensions, or corners that lie more
// than a tenth of a step apart, which is more than headers round.
void requireSameGrid(const LabelMap& map, const volume::GridGeometry& geometry,
                     const std::filesystem::path& volume);

} // namespace vs::cli

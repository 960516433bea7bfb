// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/geometry.h"

#include <cstdint>
#include <filesystem>
#include <span>
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

// The smallest number from 1 on that is no label yet.
std::int64_t nextFreeValue(const LabelMap& map);

// Writes a label map, whole numbers of the smallest of uint8, int16 and uint32 that hold all `values`: one
// for each label that occurs, by label; what is 0 stays 0. Throws WriteError naming the file.
void writeLabelMap(const std::filesystem::path& path, const volume::GridGeometry& geometry,
                   std::span<const std::uint8_t> labels, std::span<const std::int64_t> values);

} // namespace vs::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/brick_source.h"
#include "volume/grid/geometry.h"
#include "volume/reading/label_looks.h"
#include "volume/reading/store_bricks.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vs::volume {

// A label map as read from a file: each voxel holds the number of its label, counted from 1 in the order of
// the labels' values in the file; 0 is none.
struct LabelMap {
    std::filesystem::path path;
    GridGeometry geometry;
    std::vector<std::uint8_t> labels;
    std::vector<std::int64_t> values; // by label; the first is 0
    std::string checksum;             // of the file's values (volume.h)
    LabelLooks looks = {};
};

// Reads any format that volumes are read from; notices are appended. Of a store the level that has as many
// voxels as `like`, or the finest. Throws ReadError, also for values that are no whole numbers and for more
// than 255 different ones.
LabelMap readLabelMap(const std::filesystem::path& path, std::vector<std::string>& notices,
                      const GridGeometry* like = nullptr);

// The most labels that a map may have beside 0.
inline constexpr std::size_t kMostLabels = 255;

// A level of a store of labels, to be read box by box.
struct LabelLevel {
    std::shared_ptr<const BrickSource> source;
    int level = 0;
    GridGeometry geometry;
    LabelLooks looks;
};
// The level that has as many voxels as `like`; nothing: none has. Throws ReadError.
std::optional<LabelLevel> openLabelLevel(const std::filesystem::path& store, const GridGeometry& like);

// Throws Error if the label map's grid is not that of the volume: other dimensions, or corners that lie more
// than a tenth of a step apart, which is more than headers round.
void requireSameGrid(const LabelMap& map, const GridGeometry& geometry, const std::filesystem::path& volume);

} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/reading/label_map.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vs::cli {

using volume::LabelMap;
using volume::requireSameGrid;

// volume::readLabelMap(), which prints the notices.
LabelMap readLabelMap(const std::filesystem::path& path, const volume::GridGeometry* like = nullptr);

// The smallest number from 1 on that is no label yet.
std::int64_t nextFreeValue(const LabelMap& map);

// Writes a label map, whole numbers of the smallest of uint8, int16 and uint32 that hold all `values`: one
// for each label that occurs, by label; what is 0 stays 0. Throws WriteError naming the file.
void writeLabelMap(const std::filesystem::path& path, const volume::GridGeometry& geometry,
                   std::span<const std::uint8_t> labels, std::span<const std::int64_t> values);

} // namespace vs::cli

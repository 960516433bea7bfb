// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_set.h"
#include "volume/grid/brick_source.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace vs::segment {

// The voxels of each label of a label map but 0, by its value.
using LabelSets = std::map<std::int64_t, FineSet>;

// The labels of a level of a map that is read block by block. Blocks that hold nothing but 0, as far as the
// source knows without reading them, are not read. Throws ReadError, also for values that are no whole
// numbers and for more than `mostLabels` different ones.
LabelSets labelSets(const volume::BrickSource& map, int level, std::size_t mostLabels);

// The labels of a map in memory (x fastest), each voxel of which has the number of its value.
LabelSets labelSets(std::span<const std::uint8_t> labels, const std::vector<std::int64_t>& values,
                    glm::ivec3 dims);

// What tells maps apart, however they were read.
std::string checksum(const LabelSets& sets);
bool isOfSets(const std::string& checksum);

} // namespace vs::segment

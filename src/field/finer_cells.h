// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "field/cell_ranges.h"
#include "volume/grid/brick_source.h"

#include <optional>

namespace vs::field {

// The macrocells of a scene whose pictures are drawn from finer levels: what samples of any of them can find
// in each, by the ranges of the finest, whose grid lies so in the scene's voxel space. Where no ranges are
// known, anything may be anywhere.
// `ofScene`: what the scene's own voxels have, for stores of which not all is known: in those a finer level
// may be empty where a coarser one is not. Null: it counts for nothing.
CellRanges finerCellRanges(glm::ivec3 sceneDims, const BrickGrid& finest,
                           const std::optional<volume::CellExtremes>& extremes,
                           const CellRanges* ofScene = nullptr);

} // namespace vs::field

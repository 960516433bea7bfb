// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include "volume/grid/geometry.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vs::mesh {

// The smooth surface of one segment, where its membership (segment/membership/membership.h) is 0.5: what the
// renderer draws of it where no other segment is beside it. `box` holds all its voxels
// (segment/edits/label_sets.h). Empty when the label does not occur.
Mesh segmentSurface(std::span<const std::uint8_t> labels, const volume::GridGeometry& geometry,
                    std::uint8_t label, const Box3& box);

// The labels of a grid that are not in memory as a whole.
struct LabelsByBox {
    std::function<std::vector<std::uint8_t>(const Box3&)> labels; // of a box of the grid, x fastest
    std::function<bool(const Box3&)> isEmpty;                     // whether one is known to have none
};
// The surface of a segment of such labels, to the point as of labels in memory, made piece by piece. Throws
// GivenUp when `progress` says so.
Mesh segmentSurface(const LabelsByBox& labels, const volume::GridGeometry& geometry, std::uint8_t label,
                    const Progress& progress = {});

} // namespace vs::mesh

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include "volume/grid/geometry.h"

#include <cstdint>
#include <span>

namespace vs::mesh {

// The smooth surface of one segment, where its membership (segment/membership/membership.h) is 0.5: what the
// renderer draws of it where no other segment is beside it. `box` holds all its voxels
// (segment/edits/label_sets.h). Empty when the label does not occur.
Mesh segmentSurface(std::span<const std::uint8_t> labels, const volume::GridGeometry& geometry,
                    std::uint8_t label, const Box3& box);

} // namespace vs::mesh

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/scene.h"
#include "mesh/mesh.h"
#include "volume/grid/volume.h"

#include <cstdint>
#include <vector>

namespace vs::mesh {

// A volume and what was cut of it, as surface mode shows it: values within `range` on the visible side.
struct VisibleVolume {
    const volume::Volume* volume = nullptr;
    Range range;
    // The sculpture in 65535ths, 65535 cut away, one for each voxel; empty where nothing is cut.
    std::vector<std::uint16_t> sculpture = {};
    field::SculptureView view = field::SculptureView::Cut;
    const volume::GridGeometry* geometry = nullptr; // where the voxels lie; null: where the volume says

    [[nodiscard]] bool isVisible(std::size_t voxel) const;
};

// A value of the sculpture, from 0 to 1, as VisibleVolume holds it.
std::uint16_t packed(float sculpture);

// The surface of what is visible: where trilinear values cross an end of the range, capped where the
// sculpture crosses 0.5 and at the grid's border. Each point lies where the line between two voxels leaves
// what is visible, so cut faces stay smooth. Empty when nothing is visible.
Mesh visibleSurface(const VisibleVolume& visible);

} // namespace vs::mesh

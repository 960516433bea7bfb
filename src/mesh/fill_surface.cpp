// SPDX-License-Identifier: Apache-2.0
#include "mesh/fill_surface.h"

#include "mesh/contour.h"

#include <algorithm>

namespace vs::mesh {

namespace {

Box3 boxOf(const field::Fill& fill, std::uint8_t material) {
    Box3 box;
    for (const auto& [place, brick] : fill.bricks().entries()) {
        const auto& own = brick->material;
        if (std::find(own.begin(), own.end(), material) != own.end()) {
            box = box.isEmpty() ? fill.boxOf(place) : unite(box, fill.boxOf(place));
        }
    }
    return box;
}

} // namespace

Mesh fillSurface(const field::Fill& fill, std::uint8_t material, const volume::GridGeometry& geometry) {
    const auto shareOf = [&fill, material](glm::ivec3 voxel) {
        const field::Fill::Voxel there = fill.at(voxel);
        return there.material == material ? double(there.filled) : 0.0;
    };
    const Box3 box = boxOf(fill, material);
    if (box.isEmpty()) {
        return {};
    }
    segment::VoxelSet set = segment::emptySet(box);
    forEachVoxel(box,
                 [&](glm::ivec3 voxel, std::size_t n) { set.inside[n] = shareOf(voxel) >= 0.5 ? 1 : 0; });
    return contour(set, geometry, [&](glm::ivec3 inside, glm::ivec3 outside) {
        const double from = shareOf(inside);
        return (from - 0.5) / std::max(from - shareOf(outside), 1e-6);
    });
}

} // namespace vs::mesh

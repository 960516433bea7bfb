// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/geometry.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace vs::segment {

// Labels of a grid from a function of the places of the voxels' centres, in mm.
inline std::vector<std::uint8_t> labelsWhere(const volume::GridGeometry& grid,
                                             const std::function<int(glm::dvec3 world)>& label) {
    std::vector<std::uint8_t> labels;
    labels.reserve(grid.voxelCount());
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x) {
                labels.push_back(std::uint8_t(label(grid.worldFromVoxel * glm::dvec4(x, y, z, 1))));
            }
        }
    }
    return labels;
}

// A grid of at least this many mm each way, its middle at the world's origin.
inline volume::GridGeometry centredGrid(double sizeMm, glm::dvec3 spacing) {
    auto grid = volume::makeGeometry(glm::ivec3(glm::ceil(sizeMm / spacing)) + 1, spacing);
    grid.worldFromVoxel[3] = glm::dvec4(-grid.centreWorld() + 0.3 * spacing, 1); // not quite on a voxel
    return grid;
}

inline bool isInEllipsoid(glm::dvec3 place, glm::dvec3 radii) {
    return glm::dot(place / radii, place / radii) <= 1;
}

inline bool isInBox(glm::dvec3 place, glm::dvec3 halfSize) {
    return glm::all(glm::lessThanEqual(glm::abs(place), halfSize));
}

} // namespace vs::segment

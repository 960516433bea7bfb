// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/brick_grid.h"

#include <cmath>

namespace vs::field {

std::optional<BrickGrid> brickGrid(const volume::GridGeometry& level, const volume::GridGeometry& scene,
                                   int side) {
    const glm::dmat4 levelFromScene = level.voxelFromWorld() * scene.worldFromVoxel;
    BrickGrid grid{level.dims, side};
    for (int axis = 0; axis < 3; ++axis) {
        grid.perSceneVoxel[axis] = levelFromScene[axis][axis];
        grid.origin[axis] = levelFromScene[3][axis];
        // Over all voxels of the scene no place may be off by more than a thousandth of a voxel.
        for (int other = 0; other < 3; ++other) {
            const double off = levelFromScene[axis][other] * scene.dims[axis];
            if (other != axis && std::abs(off) > 1e-3) {
                return {};
            }
        }
    }
    if (glm::any(glm::lessThan(grid.perSceneVoxel, glm::dvec3(1e-6)))) {
        return {};
    }
    // What is the same grid but for rounding is the very same: places are then not moved by a hair.
    if (glm::all(glm::lessThan(glm::abs(grid.perSceneVoxel - 1.0), glm::dvec3(1e-9)))) {
        grid.perSceneVoxel = glm::dvec3(1);
        grid.origin = glm::round(grid.origin * 1e6) / 1e6;
    }
    grid.spacing = level.spacing() / scene.stepMm();
    grid.step = level.stepMm() / scene.stepMm();
    return grid;
}

volume::GridGeometry finerGeometry(const volume::GridGeometry& scene, const BrickGrid& grid) {
    volume::GridGeometry finer = scene;
    finer.dims = grid.dims;
    glm::dmat4 sceneFromLevel(1);
    for (int axis = 0; axis < 3; ++axis) {
        sceneFromLevel[axis][axis] = 1 / grid.perSceneVoxel[axis];
        sceneFromLevel[3][axis] = -grid.origin[axis] / grid.perSceneVoxel[axis];
    }
    finer.worldFromVoxel = scene.worldFromVoxel * sceneFromLevel;
    return finer;
}

} // namespace vs::field

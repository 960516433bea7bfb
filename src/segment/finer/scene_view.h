// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "segment/finer/fine_growth.h"
#include "segment/growth/growth_mirror.h"

#include <cstdint>
#include <map>
#include <vector>

namespace vs::segment {

// What has grown at the finest level, as the level that is worked on shows it. A voxel of the scene is in the
// segment that has at least half of it; or in one that has any of it, where the segment is so thin that it
// has half of no voxel around. It enters in the generation in which the segment gets to have that much.
class SceneView {
public:
    // `grid` is the finest level's, in the scene's voxel space.
    SceneView(const field::BrickGrid& grid, glm::ivec3 sceneDims);

    // Brings the scene's segments up to date.
    void update(FineGrowth& finest, Growth& scene) const;

    // The finest voxels that lie in a voxel of the scene.
    [[nodiscard]] Box3 finestIn(glm::ivec3 sceneVoxel) const {
        return finestIn(Box3{sceneVoxel, sceneVoxel + 1});
    }
    [[nodiscard]] Box3 finestIn(const Box3& sceneBox) const;
    // The voxel of the scene that a finest one lies in.
    [[nodiscard]] glm::ivec3 sceneVoxelOf(glm::ivec3 finest) const;

private:
    [[nodiscard]] MirroredBrick seen(const FineGrowth& finest, const Box3& sceneBrick) const;
    void seeSlab(const FineGrowth& finest, const Box3& slab, const Box3& sceneBrick,
                 MirroredBrick& brick) const;

    field::BrickGrid grid_;
    glm::ivec3 sceneDims_;
};

} // namespace vs::segment

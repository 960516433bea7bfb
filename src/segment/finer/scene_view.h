// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "segment/finer/fine_growth.h"
#include "segment/finer/finest_edges.h"
#include "segment/finer/scene_shares.h"
#include "segment/growth/growth_mirror.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace vs::segment {

// What has grown at the finest level, as the level that is worked on shows it. A voxel of the scene is in the
// segment that has most of its finest voxels, if that is at least half of them; or if the segment is so thin
// there that it has half of no voxel around. It enters in the generation in which the segment gets to have
// that much.
class SceneView {
public:
    // `grid` is the finest level's, in the scene's voxel space.
    SceneView(const field::BrickGrid& grid, glm::ivec3 sceneDims);

    // Whether generations are being gone through: then those after the playhead stay ready to be shown, and
    // count for where segments are thin.
    enum class Going { Nowhere, Through };
    // Brings the scene's segments up to date, always the same ones. The cost follows the bricks of the finest
    // level that have changed.
    void update(FineGrowth& finest, Growth& scene, Going going = Going::Nowhere);

    // The finest voxels that lie in a voxel of the scene.
    [[nodiscard]] Box3 finestIn(glm::ivec3 sceneVoxel) const;
    // The voxel of the scene that a finest one lies in.
    [[nodiscard]] glm::ivec3 sceneVoxelOf(glm::ivec3 finest) const;

private:
    void countUpTo(const FineGrowth& finest, Going going, std::set<std::uint32_t>& changed);
    void tell(std::uint32_t number, const BrickTable& table, MirroredBrick& brick) const;
    [[nodiscard]] std::vector<std::uint8_t> halvesIn(const Box3& box, const BrickTable& table) const;

    field::BrickGrid grid_;
    glm::ivec3 sceneDims_;
    FinestEdges edges_;                           // of all of the scene
    std::uint8_t label_ = 1;                      // of the segment at work at the last update
    int upTo_ = 0;                                // generations of it after this one do not count
    std::map<std::uint32_t, SceneShares> shares_; // by brick of the scene; none: it has nothing
};

} // namespace vs::segment

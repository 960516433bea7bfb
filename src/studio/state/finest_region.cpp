// SPDX-License-Identifier: Apache-2.0
#include "studio/state/finest_region.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace vs::studio {

namespace {

void sortUnique(std::vector<glm::ivec3>& voxels) {
    std::sort(voxels.begin(), voxels.end(),
              [](glm::ivec3 a, glm::ivec3 b) { return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x); });
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
}

// Edits of bricks, put together voxel by voxel.
class EditList {
public:
    explicit EditList(const segment::FineGrowth& growth) : growth_(growth) {}

    void add(const Box3& finest, bool isGiven) {
        forEachVoxel(finest, [&](glm::ivec3 voxel, std::size_t) {
            segment::FineGrowth::BrickEdit& edit = edits_[growth_.brickOf(voxel)];
            segment::set(isGiven ? edit.given : edit.taken, segment::cellOf(voxel & (field::kBrick - 1)));
        });
    }
    [[nodiscard]] FinestRegion::Edits take() {
        FinestRegion::Edits list;
        list.reserve(edits_.size());
        for (auto& [brick, edit] : edits_) {
            edit.brick = brick;
            list.push_back(edit);
        }
        return list;
    }

private:
    const segment::FineGrowth& growth_;
    std::map<std::uint32_t, segment::FineGrowth::BrickEdit> edits_;
};

} // namespace

FinestRegion::FinestRegion(const FinestLevel& level, const field::Field& scene,
                           const sculpt::Sculpture& sculpture)
    : grid_(level.grid),
      growth_(
          std::make_unique<segment::FineValues>(level.source, scene, geometry(scene.geometry),
                                                level.hostBytes, level.threads),
          [&sculpture] { return sculpture.finer()->reader(); }, level.hostBytes / 2),
      sceneDims_(scene.geometry.dims), view_(level.grid, scene.geometry.dims) {}

std::vector<glm::ivec3> FinestRegion::finestIn(const std::vector<glm::ivec3>& sceneVoxels) const {
    std::vector<glm::ivec3> finest;
    for (const glm::ivec3 voxel : sceneVoxels) {
        forEachVoxel(view_.finestIn(voxel), [&](glm::ivec3 v, std::size_t) { finest.push_back(v); });
    }
    return finest;
}

std::vector<glm::ivec3> FinestRegion::found(const field::SurfacePoints& points,
                                            const segment::Constraints& constraints) const {
    const std::size_t count = std::size_t(points.size.x) * std::size_t(points.size.y);
    if (count == 0) {
        return {};
    }
    std::vector<glm::dvec3> places;
    for (const field::SurfacePoint& point : points.points.read<field::SurfacePoint>(count)) {
        if (point.voxel.w >= 0.5F) {
            places.push_back(glm::dvec3(point.voxel) * grid_.perSceneVoxel + grid_.origin);
        }
    }
    std::vector<glm::ivec3> voxels = growth_.nearestAdmitted(places, constraints);
    sortUnique(voxels);
    return voxels;
}

FinestRegion::Edits FinestRegion::painting(const segment::VoxelSet& set, bool isToAdd) const {
    EditList edits(growth_);
    forEachVoxel(set.box, [&](glm::ivec3 voxel, std::size_t i) {
        if (set.inside[i] != 0) {
            edits.add(view_.finestIn(voxel), isToAdd);
        }
    });
    return edits.take();
}

FinestRegion::Edits FinestRegion::replacing(const segment::VoxelSet& before,
                                            const segment::VoxelSet& after) const {
    EditList edits(growth_);
    // What is left of the segment in voxels beside those that it lost goes with them.
    segment::VoxelSet besideGone = segment::emptySet(grow(unite(before.box, after.box), 1));
    forEachVoxel(before.box, [&](glm::ivec3 voxel, std::size_t i) {
        if (before.inside[i] != 0 && !after.contains(voxel)) {
            forEachVoxel(grow(Box3{voxel, voxel + 1}, 1), [&](glm::ivec3 near, std::size_t) {
                besideGone.inside[besideGone.indexOf(near)] = 1;
            });
        }
    });
    const Box3 scene{glm::ivec3(0), sceneDims_};
    forEachVoxel(intersect(besideGone.box, scene), [&](glm::ivec3 voxel, std::size_t) {
        const bool is = after.contains(voxel);
        if (is && !before.contains(voxel)) {
            edits.add(view_.finestIn(voxel), true);
        } else if (!is && besideGone.inside[besideGone.indexOf(voxel)] != 0) {
            edits.add(view_.finestIn(voxel), false);
        }
    });
    return edits.take();
}

} // namespace vs::studio

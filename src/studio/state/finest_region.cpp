// SPDX-License-Identifier: Apache-2.0
#include "studio/state/finest_region.h"

#include <algorithm>
#include <tuple>

namespace vs::studio {

namespace {

void sortUnique(std::vector<glm::ivec3>& voxels) {
    std::sort(voxels.begin(), voxels.end(),
              [](glm::ivec3 a, glm::ivec3 b) { return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x); });
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
}

} // namespace

FinestRegion::FinestRegion(const FinestLevel& level, const field::Field& scene,
                           const sculpt::Sculpture& sculpture)
    : source_(level.source), grid_(level.grid),
      growth_(
          std::make_unique<segment::FineValues>(level.source, scene, geometry(scene.geometry),
                                                level.hostBytes, level.threads),
          [&sculpture] { return sculpture.finer()->reader(); }, level.hostBytes / 2),
      view_(level.grid, scene.geometry.dims) {}

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

segment::FineSet FinestRegion::finestOf(const segment::VoxelSet& set) const {
    segment::FineSet finest(grid_.dims);
    forEachVoxel(set.box, [&](glm::ivec3 voxel, std::size_t i) {
        if (set.inside[i] != 0) {
            const Box3 inVoxel = view_.finestIn(voxel);
            for (int z = inVoxel.lo.z; z < inVoxel.hi.z; ++z) {
                for (int y = inVoxel.lo.y; y < inVoxel.hi.y; ++y) {
                    finest.addRow(inVoxel.lo.x, inVoxel.hi.x, y, z);
                }
            }
        }
    });
    return finest;
}

} // namespace vs::studio

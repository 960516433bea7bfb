// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "sculpt/sculpture/sculpture.h"
#include "segment/edits/voxel_set.h"
#include "segment/finer/scene_view.h"
#include "volume/grid/brick_source.h"

#include <memory>
#include <vector>

namespace vs::studio {

// The finest level of a scan that is worked on at a coarser one.
struct FinestLevel {
    std::shared_ptr<const volume::BrickSource> source;
    field::BrickGrid grid;     // of its finest level, in the scene's voxel space
    std::size_t hostBytes = 0; // that growth may take for values, and half as much for its front
    int threads = 2;           // that read
};

// The segments of a document that grow at such a level, and what the scene shows of them. What is said in
// voxels of the scene means all finest voxels in them.
class FinestRegion {
public:
    // All but `level` must outlive it; the sculpture has a finer one, which fences growth.
    FinestRegion(const FinestLevel& level, const field::Field& scene, const sculpt::Sculpture& sculpture);

    [[nodiscard]] const volume::BrickSource& source() const { return *source_; }
    segment::FineGrowth& growth() { return growth_; }
    [[nodiscard]] const segment::FineGrowth& growth() const { return growth_; }
    // Brings the scene's segments up to date.
    void show(segment::Growth& scene) { view_.update(growth_, scene, segment::SceneView::Going::Nowhere); }
    // Does so while generations are gone through: what comes later stays ready to be shown.
    void scrub(segment::Growth& scene) { view_.update(growth_, scene, segment::SceneView::Going::Through); }
    // Voxels lie where the scene now says.
    void follow(const volume::GridGeometry& scene) { growth_.follow(geometry(scene)); }
    [[nodiscard]] volume::GridGeometry geometry(const volume::GridGeometry& scene) const {
        return field::finerGeometry(scene, grid_);
    }

    [[nodiscard]] std::vector<glm::ivec3> finestIn(const std::vector<glm::ivec3>& sceneVoxels) const;
    // The finest voxels nearest to points in the scene's voxel space that the rules let in, as
    // segment::SeedFinder::find() finds the scene's.
    [[nodiscard]] std::vector<glm::ivec3> found(const field::SurfacePoints& points,
                                                const segment::Constraints& constraints) const;

    // All finest voxels in a set of the scene's.
    [[nodiscard]] segment::FineSet finestOf(const segment::VoxelSet& set) const;

private:
    std::shared_ptr<const volume::BrickSource> source_;
    field::BrickGrid grid_;
    segment::FineGrowth growth_;
    segment::SceneView view_;
};

} // namespace vs::studio

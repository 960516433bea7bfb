// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/radiation/radiation.h"
#include "sculpt/radiation/tool_points.h"
#include "sculpt/sculpture/cut_target.h"
#include "sculpt/surface/tool_surface.h"

namespace vs::sculpt {

// One stamp of a tool: what it sweeps, and whether that is cut away or restored.
struct ToolCut {
    ToolSweep sweep;
    Combine how = Combine::Cut;
};

// Runs stamps: surface points and mask to swept solid to points to radiation to sculpture. Keeps what they
// share (shaders, buffers, scratch textures), so one lasts as long as the document.
class ToolCutter {
public:
    explicit ToolCutter(const volume::GridGeometry& geometry) : geometry_(geometry) {}
    // From now on voxels lie there.
    void follow(const volume::GridGeometry& geometry) { geometry_ = geometry; }

    // `surface` holds one point per element of `mask`. Bricks are protected in `backup` (if any) before they
    // change. Several stamps make a stroke: each is united with the sculpture, so overlaps count once.
    // Returns the box of voxels that may have changed; empty when the stamp does nothing.
    Box3 cut(Sculpture& sculpture, const field::SurfacePoints& surface, const MaskRaster& mask,
             const ToolCut& cut, BrickBackup* backup);
    // Runs a stamp whose surface points are at hand in memory.
    Box3 cut(Sculpture& sculpture, std::span<const field::SurfacePoint> surface, const MaskRaster& mask,
             const ToolCut& cut, BrickBackup* backup) {
        WholeTarget target(sculpture, backup);
        return this->cut(target, surface, mask, cut);
    }
    Box3 cut(CutTarget& target, std::span<const field::SurfacePoint> surface, const MaskRaster& mask,
             const ToolCut& cut);

    [[nodiscard]] Radiator& radiator() { return radiator_; }
    [[nodiscard]] PointGenerator& generator() { return generator_; }

private:
    volume::GridGeometry geometry_;
    Radiator radiator_;
    PointGenerator generator_;
};

} // namespace vs::sculpt

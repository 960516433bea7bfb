// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/tool_cut.h"

#include "base/check.h"

namespace vs::sculpt {

Box3 ToolCutter::cut(Sculpture& sculpture, const field::SurfacePoints& surface, const MaskRaster& mask,
                     const ToolCut& cut, BrickBackup* backup) {
    VS_CHECK(surface.size == mask.size);
    if (mask.values.empty() || !(cut.sweep.depthSteps > 0)) {
        return {};
    }
    return this->cut(sculpture, surface.points.read<field::SurfacePoint>(mask.values.size()), mask, cut,
                     backup);
}

Box3 ToolCutter::cut(Sculpture& sculpture, std::span<const field::SurfacePoint> surface,
                     const MaskRaster& mask, const ToolCut& cut, BrickBackup* backup) {
    const SweptPatches patches = sweepSurface(surface, mask, geometry_, cut.sweep);
    if (patches.patches().empty()) {
        return {};
    }
    radiator_.begin(patches.pointBox(), geometry_.dims, fitFootprint(cut.sweep.radius, geometry_.spacing()));
    generator_.generate(
        patches, [&](const gl::Buffer& points, std::size_t count) { radiator_.deposit(points, count); });
    const Box3 touched = radiator_.finish();
    if (backup != nullptr) {
        backup->protect(touched);
    }
    return sculpture.combine(radiator_, cut.how);
}

} // namespace vs::sculpt

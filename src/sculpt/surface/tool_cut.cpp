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

Box3 ToolCutter::cut(CutTarget& target, std::span<const field::SurfacePoint> surface, const MaskRaster& mask,
                     const ToolCut& cut) {
    const SweptPatches patches = sweepSurface(surface, mask, geometry_, cut.sweep);
    if (patches.patches().empty()) {
        return {};
    }
    const Footprint footprint = fitFootprint(cut.sweep.radius, geometry_.spacing());
    const auto cutPart = [&](const CutTarget::Part& part) {
        radiator_.begin(patches.pointBox(), part.within, footprint);
        generator_.generateIn(
            reachOf(part.within, footprint), patches,
            [&](const gl::Buffer& points, std::size_t count) { radiator_.deposit(points, count); });
        const Box3 touched = radiator_.finish();
        if (part.backup != nullptr) {
            part.backup->protect(touched);
        }
        return part.sculpture->combine(radiator_, cut.how);
    };
    return target.cutIn(reachOf(patches.pointBox(), footprint), cutPart, [&](const Box3& box) {
        return !patches.patchesIn(reachOf(box, footprint)).patches.empty();
    });
}

} // namespace vs::sculpt

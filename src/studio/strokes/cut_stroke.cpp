// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/cut_stroke.h"

#include "studio/operations/sketch.h"

namespace vs::studio {

namespace {

// Mask elements lie about half a step apart on a surface in the middle of the volume: dense enough for the
// radiation, whatever the zoom.
constexpr double kElementSteps = 0.5;
// Nor more than this many along a side, for a sketch that is huge in voxels.
constexpr double kMaxElements = 1500;

} // namespace

sculpt::BrickDelta CutStroke::finish() {
    sculpt::BrickDelta delta = backup_.finish();
    if (delta.isEmpty()) {
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
    return delta;
}

void CutStroke::discard() {
    if (!backup_.isEmpty()) {
        cutter_->sculpture->refresh(backup_.restore());
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
}

ToolMask::ToolMask(const Sketch& sketch, const render::Frame& frame, const volume::GridGeometry& geometry) {
    auto outline = outlineOf(sketch);
    drawnAt = centreOf(outline);
    for (auto& point : outline) {
        point -= drawnAt;
        extent = glm::max(extent, 2.0 * glm::abs(point));
    }
    const double pixelMm = frame.rays.pixelMm(geometry.centreWorld());
    const double pitch =
        std::max(kElementSteps * geometry.stepMm() / pixelMm, std::max(extent.x, extent.y) / kMaxElements);
    raster = sculpt::rasterize(outline, pitch);
}

std::vector<glm::vec2> pixelsOf(const sculpt::MaskRaster& raster, glm::dvec2 centre) {
    std::vector<glm::vec2> pixels;
    pixels.reserve(raster.values.size());
    for (int j = 0; j < raster.size.y; ++j) {
        for (int i = 0; i < raster.size.x; ++i) {
            pixels.emplace_back(centre + raster.origin + raster.pitch * glm::dvec2(i, j));
        }
    }
    return pixels;
}

} // namespace vs::studio

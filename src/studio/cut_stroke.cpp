// SPDX-License-Identifier: Apache-2.0
#include "studio/cut_stroke.h"

#include "studio/sketch.h"

#include <cmath>

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

MaskSweep ToolMask::along(glm::dvec2 from, glm::dvec2 to, double depthFrom, double depthTo) const {
    MaskSweep sweep;
    sweep.centre = 0.5 * (from + to);
    if (raster.values.empty()) {
        return sweep;
    }
    const glm::dvec2 way = (to - from) / raster.pitch; // in elements
    const glm::ivec2 margin(glm::ceil(0.5 * glm::abs(way)));
    sweep.raster.pitch = raster.pitch;
    sweep.raster.size = raster.size + 2 * margin;
    sweep.raster.origin = raster.origin - raster.pitch * glm::dvec2(margin);
    const glm::ivec2 size = sweep.raster.size;
    sweep.raster.values.assign(std::size_t(size.x) * std::size_t(size.y), 0.0F);
    sweep.depths.assign(sweep.raster.values.size(), 0.0F);
    // Half an element apart, the mask's edge (two elements wide) shows no steps.
    const int places = 2 + int(std::ceil(2 * glm::length(way))); // both ends
    for (int n = 0; n < places; ++n) {
        const double s = double(n) / (places - 1);
        sweep.cover(raster, glm::dvec2(margin) + (s - 0.5) * way, float(glm::mix(depthFrom, depthTo, s)));
    }
    return sweep;
}

// The mask shifted by so many elements: bilinear between its own.
void MaskSweep::cover(const sculpt::MaskRaster& mask, glm::dvec2 shift, float depth) {
    if (!(depth > 0)) {
        return;
    }
    const glm::ivec2 whole(glm::floor(shift));
    const glm::vec2 f(shift - glm::dvec2(whole));
    const auto value = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < mask.size.x && j < mask.size.y ? mask.at(i, j) : 0.0F;
    };
    for (int j = 0; j <= mask.size.y; ++j) {
        for (int i = 0; i <= mask.size.x; ++i) {
            const glm::ivec2 e = whole + glm::ivec2(i, j);
            if (e.x < 0 || e.y < 0 || e.x >= raster.size.x || e.y >= raster.size.y) {
                continue;
            }
            const float covered = glm::mix(glm::mix(value(i, j), value(i - 1, j), f.x),
                                           glm::mix(value(i, j - 1), value(i - 1, j - 1), f.x), f.y);
            if (covered > 0) {
                const std::size_t n = std::size_t(e.y) * std::size_t(raster.size.x) + std::size_t(e.x);
                raster.values[n] = std::max(raster.values[n], covered);
                depths[n] = std::max(depths[n], depth);
            }
        }
    }
}

std::vector<glm::vec2> MaskSweep::pixels() const {
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

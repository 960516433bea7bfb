// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/tool_mask.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vs::studio {

namespace {

// Mask elements lie about half a step apart on a surface in the middle of the volume: dense enough for the
// radiation, whatever the zoom.
constexpr double kElementSteps = 0.5;
// Nor more than this many along a side, for a sketch that is huge in voxels.
constexpr double kMaxElements = 1500;
// What tools radiate from beside the volume still reaches it from this many steps away: the far side of a
// skirt of twice the largest radius, and the radiation's own.
constexpr double kReachSteps = 16;

constexpr sculpt::MaskWindow kUnbounded{glm::dvec2(-1e300), glm::dvec2(1e300)};

std::array<glm::dvec3, 8> cornersWithReach(const volume::GridGeometry& geometry) {
    const glm::dvec3 reach = kReachSteps * geometry.stepMm() / geometry.spacing();
    std::array<glm::dvec3, 8> corners{};
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const glm::dvec3 voxel((n & 1U) != 0 ? geometry.dims.x - 1 + reach.x : -reach.x,
                               (n & 2U) != 0 ? geometry.dims.y - 1 + reach.y : -reach.y,
                               (n & 4U) != 0 ? geometry.dims.z - 1 + reach.z : -reach.z);
        corners[n] = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
    }
    return corners;
}

// Whether a place is before the viewer: only such have a place in the picture.
bool isBefore(const glm::dvec3& world, const render::ViewRays& rays) {
    return rays.isOrthographic || glm::dot(world - rays.eye, rays.forward) > 1e-3;
}

glm::dvec2 extentOf(const sculpt::Outline& outline) {
    glm::dvec2 extent(0);
    for (const glm::dvec2& point : outline) {
        extent = glm::max(extent, 2.0 * glm::abs(point));
    }
    return extent;
}

} // namespace

double acrossMm(const volume::GridGeometry& geometry) {
    const auto corners = cornersWithReach(geometry);
    double most = 0; // of the four diagonals
    for (std::size_t n = 0; n < 4; ++n) {
        most = std::max(most, glm::distance(corners[n], corners[7 - n]));
    }
    return most;
}

sculpt::MaskWindow pictureOf(const volume::GridGeometry& geometry, const render::ViewRays& rays) {
    sculpt::MaskWindow picture;
    for (const glm::dvec3& corner : cornersWithReach(geometry)) {
        if (!isBefore(corner, rays)) {
            return kUnbounded;
        }
        const glm::dvec2 pixel = rays.project(corner);
        picture.include({pixel, pixel});
    }
    return picture;
}

namespace {

// What of a mask about the origin can meet the volume when it is led to `places`: seen along the view, or
// lying on a surface, whichever way it is turned.
sculpt::MaskWindow usefulPart(const volume::GridGeometry& geometry, const render::ViewRays& rays,
                              const sculpt::MaskWindow& places) {
    const sculpt::MaskWindow picture = pictureOf(geometry, rays);
    sculpt::MaskWindow useful{picture.lo - places.hi, picture.hi - places.lo};
    if (picture.lo.x > kUnbounded.lo.x) {
        double finest = 1e300; // mm a pixel, anywhere in the volume
        for (const glm::dvec3& corner : cornersWithReach(geometry)) {
            finest = std::min(finest, rays.pixelMm(corner));
        }
        const glm::dvec2 across(acrossMm(geometry) / finest);
        useful.include({-across, across});
    }
    return useful;
}

} // namespace

ToolMask::ToolMask(const Sketch& sketch, const render::Frame& frame, const volume::GridGeometry& geometry) {
    auto outline = outlineOf(sketch);
    drawnAt = centreOf(outline);
    for (auto& point : outline) {
        point -= drawnAt;
    }
    const glm::dvec2 picture(frame.rays.size);
    const glm::dvec2 beside = glm::min(extentOf(outline), picture);
    places = {-beside, picture + beside};
    places.include({drawnAt, drawnAt});
    const sculpt::MaskWindow useful = usefulPart(geometry, frame.rays, places);
    outline = sculpt::clipToBox(std::move(outline), useful.lo, useful.hi);
    extent = extentOf(outline);
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

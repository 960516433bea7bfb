// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/solid_strokes.h"

#include "studio/operations/sketch.h"

namespace vs::studio {

namespace {

sculpt::Projector projectorOf(const render::ViewRays& rays) {
    // x w = size / 2 (dot(d, right) / |right|^2 + w), d from the eye: what ViewRays::project() does.
    const auto row = [&](glm::dvec3 v, double offset) {
        return glm::dvec4(v, offset - glm::dot(v, rays.eye));
    };
    const glm::dvec4 w = rays.isOrthographic ? glm::dvec4(0, 0, 0, 1) : row(rays.forward, 0);
    const glm::dvec4 x = 0.5 * rays.size.x * (row(rays.right / glm::dot(rays.right, rays.right), 0) + w);
    const glm::dvec4 y = 0.5 * rays.size.y * (w - row(rays.up / glm::dot(rays.up, rays.up), 0));
    sculpt::Projector projector;
    projector.pixelFromWorld = glm::transpose(glm::dmat4(x, y, glm::dvec4(0), w));
    projector.eye = rays.eye;
    projector.forward = rays.forward;
    projector.pixelMm = 2 * glm::length(rays.up) / rays.size.y;
    projector.isOrthographic = rays.isOrthographic;
    projector.viewport = rays.size;
    return projector;
}

std::vector<glm::vec2> allPixels(glm::ivec2 size) {
    std::vector<glm::vec2> pixels;
    pixels.reserve(std::size_t(size.x) * std::size_t(size.y));
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            pixels.emplace_back(x + 0.5F, y + 0.5F);
        }
    }
    return pixels;
}

// Half spaces in the world of a box in voxel space, and of planes.
std::vector<glm::dvec4> planesOf(const Clip& clip, const volume::GridGeometry& geometry) {
    std::vector<glm::dvec4> planes;
    const auto add = [&](glm::dvec3 point, glm::dvec3 normal) {
        normal = glm::normalize(normal);
        planes.emplace_back(normal, -glm::dot(normal, point));
    };
    if (clip.box) {
        const glm::dmat3 normals = glm::transpose(glm::dmat3(geometry.voxelFromWorld()));
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 lo(geometry.worldFromVoxel * glm::dvec4(clip.box->lo, 1.0));
            const glm::dvec3 hi(geometry.worldFromVoxel * glm::dvec4(clip.box->hi, 1.0));
            add(lo, -normals[axis]);
            add(hi, normals[axis]);
        }
    }
    for (const Clip::Plane& plane : clip.planes) {
        add(plane.point, plane.normal);
    }
    return planes;
}

} // namespace

ScissorsStroke::ScissorsStroke(Cutter& cutter, const MakeFrame& makeFrame, const Scissors& operation)
    : CutStroke(cutter, operation, operation.restores), frame_(makeFrame()) {}

void ScissorsStroke::replay() {
    const Scissors& op = std::get<Scissors>(operation_);
    sculpt::Extrusion solid;
    // Far beside the picture the stroke's own corners do not matter.
    const glm::dvec2 size(frame_.rays.size);
    solid.outline = sculpt::clipToBox(outlineOf(op.outline), -size, 2.0 * size);
    if (solid.outline.size() < 3) {
        return;
    }
    solid.projector = projectorOf(frame_.rays);
    solid.cutsOutside = op.cutsOutside;
    solid.radius = op.radius;
    if (op.depth) {
        limitDepth(solid, *op.depth);
    }
    cutter_->solids.extrude(target(), solid, how_);
}

// From the radius outside the surface to the depth below it; for a restore from the radius inside the surface
// to as far outside as there was something.
void ScissorsStroke::limitDepth(sculpt::Extrusion& solid, double depthSteps) {
    const double step = cutter_->geometry->stepMm();
    const double radius = solid.radius * step;
    const double depth = depthSteps * cutter_->toolSteps();
    const auto pixels = allPixels(frame_.rays.size);
    const auto points = cutter_->pick(frame_, pixels);
    std::vector<float> reach;
    if (!onlyCuts()) {
        std::vector<glm::vec3> directions;
        directions.reserve(pixels.size());
        for (const glm::vec2 pixel : pixels) {
            directions.emplace_back(frame_.rays.through(pixel).direction);
        }
        reach = cutter_->reachOf(frame_, points, directions, std::vector<float>(points.size(), float(depth)),
                                 solid.radius);
    }
    beginMm_.assign(points.size(), -1.0F);
    endMm_.assign(points.size(), -1.0F);
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (points[n].voxel.w > 0.5F && (onlyCuts() || reach[n] > 0)) {
            const double surface = points[n].normal.w;
            beginMm_[n] = float(std::max(onlyCuts() ? surface - radius : surface - reach[n] * step, 0.0));
            endMm_[n] = float(onlyCuts() ? surface + depth * step : surface + radius);
        }
    }
    solid.beginMm = beginMm_;
    solid.endMm = endMm_;
}

void ClipStroke::clipTo(const Clip& clip) {
    VS_CHECK(clip.restores == (how_ == sculpt::Combine::Restore));
    operation_ = clip;
    discard();
    const sculpt::HalfSpaces solid{planesOf(clip, *cutter_->scene), clip.cutsInside, clip.radius};
    cutter_->solids.clip(target(), solid, how_);
}

} // namespace vs::studio

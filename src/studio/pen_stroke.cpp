// SPDX-License-Identifier: Apache-2.0
#include "studio/pen_stroke.h"

#include <cmath>

namespace vs::studio {

namespace {

constexpr int kLaserSamples = 24; // along a side of the mask, to find its normal and what stands above it

// The pixels of a coarse raster over a mask, without those outside it.
std::vector<glm::dvec2> samplesOf(const ToolMask& mask) {
    std::vector<glm::dvec2> samples;
    const glm::ivec2 size = mask.raster.size;
    const glm::ivec2 stride = glm::max(size / kLaserSamples, glm::ivec2(1));
    for (int j = 0; j < size.y; j += stride.y) {
        for (int i = 0; i < size.x; i += stride.x) {
            if (mask.raster.at(i, j) >= 0.5F) {
                samples.push_back(mask.raster.origin + mask.raster.pitch * glm::dvec2(i, j));
            }
        }
    }
    return samples;
}

glm::dvec3 worldOf(const field::SurfacePoint& point, const volume::GridGeometry& geometry) {
    return {geometry.worldFromVoxel * glm::dvec4(glm::dvec3(point.voxel), 1.0)};
}

// The normal turned least from the view: what was drawn stays upright.
MaskPlane planeAt(const glm::dvec3& centre, const glm::dvec3& normal, const render::ViewRays& rays) {
    MaskPlane plane{centre, {}, {}, normal};
    const double pixelMm = rays.pixelMm(centre);
    const glm::dvec3 towards = -rays.forward;
    const glm::dvec3 axis = glm::cross(towards, normal);
    const double sine = glm::length(axis);
    const double cosine = glm::dot(towards, normal);
    const auto turned = [&](glm::dvec3 v) { // Rodrigues' formula
        if (sine < 1e-9) {
            return v;
        }
        const glm::dvec3 k = axis / sine;
        return v * cosine + glm::cross(k, v) * sine + k * glm::dot(k, v) * (1 - cosine);
    };
    plane.right = pixelMm * turned(glm::normalize(rays.right));
    plane.down = -pixelMm * turned(glm::normalize(rays.up));
    return plane;
}

} // namespace

std::optional<MaskPlane> layOnSurface(render::Picker& picker, const render::Frame& frame,
                                      const ToolMask& mask, glm::dvec2 pixel) {
    std::vector<glm::vec2> pixels{glm::vec2(pixel)};
    for (const glm::dvec2 sample : samplesOf(mask)) {
        pixels.emplace_back(pixel + sample);
    }
    const auto points = picker.pickPoints(frame, pixels);
    const volume::GridGeometry& geometry = frame.scene.data->geometry;
    if (points.front().voxel.w < 0.5F) {
        return std::nullopt;
    }
    const glm::dvec3 centre = worldOf(points.front(), geometry);
    // Hits farther away than the mask is wide belong to something else.
    const double size = std::max(mask.extent.x, mask.extent.y) * frame.rays.pixelMm(centre);
    glm::dvec3 sum(0);
    for (const auto& point : points) {
        if (point.voxel.w > 0.5F && glm::distance(worldOf(point, geometry), centre) <= size) {
            sum += glm::dvec3(point.normal);
        }
    }
    const glm::dvec3 own(points.front().normal);
    const glm::dvec3 normal = glm::length(sum) > 1e-6 && glm::dot(sum, own) > 0 ? glm::normalize(sum) : own;
    return planeAt(centre, normal, frame.rays);
}

PenStroke::PenStroke(Cutter& cutter, LookAgain look, const Drill& operation)
    : CutStroke(cutter, operation, operation.restores), look_(std::move(look)), frame_(look_()),
      mask_(operation.mask, frame_, *cutter.geometry) {
    toReplay_ = std::exchange(cut().stroke, {}); // filled again as the pen moves
    lookAgain();
}

PenStroke::PenStroke(Cutter& cutter, LookAgain look, const Laser& operation)
    : CutStroke(cutter, operation, operation.restores), look_(std::move(look)), frame_(look_()),
      mask_(operation.mask, frame_, *cutter.geometry) {
    toReplay_ = std::exchange(cut().stroke, {});
    lookAgain();
}

PenCut& PenStroke::cut() {
    Drill* drill = std::get_if<Drill>(&operation_);
    return drill != nullptr ? static_cast<PenCut&>(*drill) : std::get<Laser>(operation_);
}

void PenStroke::lookAgain() {
    frame_ = look_();
    if (!cut().keepsDigging) { // else what it sees may change under it
        if (frame_.scene.sculpture != nullptr) {
            frame_.scene.sculpture = &cutter_->snapshot();
        }
        frame_.macrocells = &cutter_->snapshot(*frame_.macrocells);
    }
}

void PenStroke::replay() {
    if (toReplay_.empty()) {
        stamp({mask_.drawnAt, 1});
    }
    for (const auto& pen : toReplay_) {
        drawAt(pen);
    }
}

void PenStroke::drawAt(const sculpt::PenPoint& pen) {
    PenCut& op = cut();
    const sculpt::PenPoint from = op.stroke.empty() ? pen : op.stroke.back();
    op.stroke.push_back(pen);
    if (from.pressure <= 0 && pen.pressure > 0) {
        lookAgain();
    }
    // Stamps a quarter of the mask apart leave no scallops along the stroke's sides.
    const double spacing = std::max(0.25 * std::min(mask_.extent.x, mask_.extent.y), 2.0);
    const int stamps = std::max(1, int(std::ceil(glm::length(pen.pixel - from.pixel) / spacing)));
    for (int i = 1; i <= stamps; ++i) {
        const double s = double(i) / stamps;
        stamp({glm::mix(from.pixel, pen.pixel, s), glm::mix(from.pressure, pen.pressure, s),
               glm::mix(from.tiltDegrees, pen.tiltDegrees, s)});
    }
}

void PenStroke::stamp(const sculpt::PenPoint& pen) {
    // Beside the picture there is nothing to cut, however long the stroke.
    const bool isInPicture = glm::all(glm::greaterThan(pen.pixel + mask_.extent, glm::dvec2(0))) &&
                             glm::all(glm::lessThan(pen.pixel - mask_.extent, glm::dvec2(frame_.rays.size)));
    const double depth = cut().depthMax * std::min(pen.pressure, 1.0);
    if (mask_.raster.values.empty() || !(depth > 0) || !isInPicture) {
        return;
    }
    if (cut().keepsDigging) {
        lookAgain();
    }
    if (std::holds_alternative<Drill>(operation_)) {
        drill(pen, depth);
    } else {
        burn(pen, depth);
    }
}

glm::dvec3 PenStroke::drillDirection(const sculpt::PenPoint& pen) const {
    const glm::dvec3 ray = frame_.rays.through(pen.pixel).direction;
    if (!std::get<Drill>(operation_).followsTilt) {
        return ray;
    }
    // Where the pen leans, its point comes from: leaning right it points to the left.
    const glm::dvec2 slope = glm::tan(glm::radians(glm::clamp(pen.tiltDegrees, -60.0, 60.0)));
    return glm::normalize(ray - slope.x * glm::normalize(frame_.rays.right) +
                          slope.y * glm::normalize(frame_.rays.up));
}

void PenStroke::drill(const sculpt::PenPoint& pen, double depth) {
    const auto surface = cutter_->picker.pickPoints(frame_, mask_.pixels(pen.pixel));
    sculpt::ToolCut tool{{}, how_};
    tool.sweep.directionWorld = drillDirection(pen);
    tool.sweep.depthSteps = depth;
    sweep(surface, tool);
}

void PenStroke::burn(const sculpt::PenPoint& pen, double depth) {
    const auto plane = layOnSurface(cutter_->picker, frame_, mask_, pen.pixel);
    if (!plane) {
        return;
    }
    const volume::GridGeometry& geometry = *cutter_->geometry;
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    std::vector<glm::dvec3> places;
    std::vector<glm::vec2> pixels; // where the mask's elements are seen once it lies on the surface
    for (int j = 0; j < mask_.raster.size.y; ++j) {
        for (int i = 0; i < mask_.raster.size.x; ++i) {
            places.push_back(plane->place(mask_.raster.origin + mask_.raster.pitch * glm::dvec2(i, j)));
            pixels.emplace_back(frame_.rays.project(places.back()));
        }
    }
    sculpt::ToolCut tool{{}, how_};
    tool.sweep.directionWorld = -plane->normal;
    tool.sweep.depthSteps = depth;
    const auto seen = cutter_->picker.pickPoints(frame_, pixels);
    if (how_ == sculpt::Combine::Restore) {
        sweep(seen, tool); // put back from each place of the floor
        return;
    }
    // The mask is flat: all its elements begin in the plane, and burn away what stands above it there too.
    double above = 0;
    const double limit = std::max(mask_.extent.x, mask_.extent.y) * glm::length(plane->right);
    std::vector<field::SurfacePoint> surface(places.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
        surface[n].voxel = glm::vec4(glm::vec3(voxelFromWorld * glm::dvec4(places[n], 1.0)), 1.0F);
        surface[n].normal = glm::vec4(plane->normal, 0.0);
        if (seen[n].voxel.w > 0.5F && mask_.raster.values[n] > 0) {
            const double height = glm::dot(worldOf(seen[n], geometry) - plane->centre, plane->normal);
            above = std::max(above, std::min(height, limit));
        }
    }
    tool.sweep.outsideSteps = cut().radius + above / geometry.stepMm();
    sweep(surface, tool);
}

void PenStroke::sweep(std::span<const field::SurfacePoint> surface, sculpt::ToolCut& tool) {
    tool.sweep.radius = cut().radius;
    std::vector<glm::vec3> directions;
    std::vector<float> reach;
    if (how_ == sculpt::Combine::Restore) {
        directions = sculpt::toolDirections(surface, mask_.raster, *cutter_->geometry, tool.sweep);
        reach = cutter_->restoreReach.measure(frame_.scene, surface, directions, tool.sweep.depthSteps,
                                              tool.sweep.radius);
        tool.sweep.directions = directions;
        tool.sweep.outwardSteps = reach;
    }
    cutter_->tools.cut(*cutter_->sculpture, surface, mask_.raster, tool, &backup_);
}

} // namespace vs::studio

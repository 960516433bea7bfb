// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/pen_stroke.h"

#include "base/progress.h"

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

std::optional<MaskPlane> layOnSurface(Cutter& cutter, const render::Frame& frame, const ToolMask& mask,
                                      glm::dvec2 pixel) {
    std::vector<glm::vec2> pixels{glm::vec2(pixel)};
    for (const glm::dvec2 sample : samplesOf(mask)) {
        pixels.emplace_back(pixel + sample);
    }
    const auto points = cutter.pick(frame, pixels);
    const volume::GridGeometry& geometry = *cutter.geometry;
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

PenStroke::PenStroke(Cutter& cutter, MakeFrame makeFrame, const Drill& operation)
    : CutStroke(cutter, operation, operation.restores), makeFrame_(std::move(makeFrame)),
      frame_(makeFrame_()), mask_(operation.mask, frame_, *cutter.geometry),
      flat_(sculpt::flatness(mask_.raster)), covered_(mask_.raster.pitch) {
    toReplay_ = std::exchange(cut().stroke, {}); // filled again as the pen moves
    detectAgain();
}

PenStroke::PenStroke(Cutter& cutter, MakeFrame makeFrame, const Laser& operation)
    : CutStroke(cutter, operation, operation.restores), makeFrame_(std::move(makeFrame)),
      frame_(makeFrame_()), mask_(operation.mask, frame_, *cutter.geometry),
      flat_(sculpt::flatness(mask_.raster)), covered_(mask_.raster.pitch) {
    toReplay_ = std::exchange(cut().stroke, {});
    detectAgain();
}

PenCut& PenStroke::cut() {
    Drill* drill = std::get_if<Drill>(&operation_);
    return drill != nullptr ? static_cast<PenCut&>(*drill) : std::get<Laser>(operation_);
}

void PenStroke::detectAgain() {
    frame_ = makeFrame_();
    covered_ = StrokeRaster(mask_.raster.pitch);
    if (!cut().keepsDigging) { // else what it sees may change under it
        if (frame_.scene.sculpture != nullptr) {
            frame_.scene.sculpture = &cutter_->snapshot();
        }
        if (frame_.scene.fill != nullptr) {
            frame_.scene.fill = &cutter_->keptFill();
        }
        frame_.macrocells = &cutter_->snapshot(*frame_.macrocells);
        cutter_->keepSurfaces();
    }
}

void PenStroke::replay() {
    if (toReplay_.empty()) {
        goTo({mask_.drawnAt, 1}, {mask_.drawnAt, 1});
    }
    for (std::size_t n = 0; n < toReplay_.size(); ++n) {
        reportProgress(double(n) / double(toReplay_.size()));
        drawAt(toReplay_[n]);
    }
}

void PenStroke::drawAt(const sculpt::PenPoint& pen) {
    PenCut& op = cut();
    const sculpt::PenPoint from = op.stroke.empty() ? pen : op.stroke.back();
    op.stroke.push_back(pen);
    if (from.pressure <= 0 && pen.pressure > 0) {
        detectAgain();
    }
    // The laser in pieces of a quarter of the mask, each with a direction of its own; the drill, where every
    // element has its own, in pieces as long as the mask.
    const double longest = std::max((std::holds_alternative<Drill>(operation_) ? 1.0 : 0.25) *
                                        std::min(mask_.extent.x, mask_.extent.y),
                                    2.0);
    const int pieces = std::max(1, int(std::ceil(glm::length(pen.pixel - from.pixel) / longest)));
    const auto at = [&](double s) {
        return sculpt::PenPoint{glm::mix(from.pixel, pen.pixel, s), glm::mix(from.pressure, pen.pressure, s),
                                glm::mix(from.tiltDegrees, pen.tiltDegrees, s)};
    };
    for (int i = 0; i < pieces; ++i) {
        goTo(at(double(i) / pieces), at(double(i + 1) / pieces));
    }
}

void PenStroke::goTo(const sculpt::PenPoint& from, const sculpt::PenPoint& to) {
    const auto isBeside = [&](glm::dvec2 pixel) {
        return glm::any(glm::lessThan(pixel, mask_.places.lo)) ||
               glm::any(glm::greaterThan(pixel, mask_.places.hi));
    };
    // Beside the picture there is nothing to cut, however long the stroke.
    if (mask_.raster.values.empty() || !(std::max(depthOf(from), depthOf(to)) > 0) ||
        (isBeside(from.pixel) && isBeside(to.pixel))) {
        return;
    }
    if (cut().keepsDigging) {
        detectAgain();
    }
    if (std::holds_alternative<Drill>(operation_)) {
        drill(from, to);
    } else {
        burn(from, to);
    }
}

double PenStroke::depthOf(const sculpt::PenPoint& pen) {
    return cut().depthMax * cutter_->toolSteps() * std::clamp(pen.pressure, 0.0, 1.0);
}

glm::dvec3 PenStroke::drillDirection(glm::dvec2 pixel, glm::dvec2 tiltDegrees) const {
    const glm::dvec3 ray = frame_.rays.through(pixel).direction;
    if (!std::get<Drill>(operation_).followsTilt) {
        return ray;
    }
    // Where the pen leans, its point comes from: leaning right it points to the left.
    const glm::dvec2 slope = glm::tan(glm::radians(glm::clamp(tiltDegrees, -60.0, 60.0)));
    return glm::normalize(ray - slope.x * glm::normalize(frame_.rays.right) +
                          slope.y * glm::normalize(frame_.rays.up));
}

// What this piece of the way changes is computed again with all that the stroke has covered around it, so
// that the result is that of the whole stroke at once.
void PenStroke::drill(const sculpt::PenPoint& from, const sculpt::PenPoint& to) {
    const auto place = [&](const sculpt::PenPoint& pen) {
        return StrokeRaster::Place{pen.pixel, depthOf(pen), drillDirection(pen.pixel, pen.tiltDegrees)};
    };
    const ElementBox changed =
        covered_.cover(mask_.raster, flat_, place(from), place(to),
                       covered_.elementsIn(pictureOf(*cutter_->geometry, frame_.rays)));
    const glm::dvec3 direction = place(to).direction;
    if (changed.isEmpty()) {
        return;
    }
    // Twice the radius: a voxel that a changed element reaches is reached by elements as far beyond it.
    const double stepPixels =
        cutter_->geometry->stepMm() / frame_.rays.pixelMm(cutter_->geometry->centreWorld());
    const int margin = 2 + int(std::ceil(2 * cut().radius * stepPixels / mask_.raster.pitch));
    static_assert((sculpt::kMaxBlock & (sculpt::kMaxBlock - 1)) == 0);
    const ElementBox box{(changed.lo - margin) & ~(sculpt::kMaxBlock - 1), changed.hi + margin};
    covered_.lookUnder(changed, [&](const auto& pixels) { return cutter_->pick(frame_, pixels); });
    auto part = covered_.part(box);
    sculpt::ToolCut tool{{}, how_};
    for (std::size_t n = 0; n < part.directions.size(); ++n) {
        if (!(part.mask.values[n] > 0)) { // nothing there, but its neighbours' cells end at it
            part.directions[n] = glm::vec3(direction);
        }
    }
    tool.sweep.directionWorld = direction;
    tool.sweep.directions = part.directions;
    sweep(part.surface, part.mask, part.depths, tool);
}

// Each piece of the way has a plane of its own, so what it covers is collected about the piece's middle.
void PenStroke::burn(const sculpt::PenPoint& from, const sculpt::PenPoint& to) {
    const glm::dvec2 centre = 0.5 * (from.pixel + to.pixel);
    const auto plane = layOnSurface(*cutter_, frame_, mask_, centre);
    if (!plane) {
        return;
    }
    const glm::dvec2 across(acrossMm(*cutter_->geometry) / glm::length(plane->right)); // in pixels
    StrokeRaster piece(mask_.raster.pitch);
    const auto mask =
        piece.part(piece.cover(mask_.raster, flat_, {from.pixel - centre, depthOf(from)},
                               {to.pixel - centre, depthOf(to)}, piece.elementsIn({-across, across})));
    std::vector<glm::dvec3> places;
    std::vector<glm::vec2> pixels; // where the mask's elements are seen once it lies on the surface
    for (int j = 0; j < mask.mask.size.y; ++j) {
        for (int i = 0; i < mask.mask.size.x; ++i) {
            places.push_back(plane->place(mask.mask.origin + mask.mask.pitch * glm::dvec2(i, j)));
            pixels.emplace_back(frame_.rays.project(places.back()));
        }
    }
    sculpt::ToolCut tool{{}, how_};
    tool.sweep.directionWorld = -plane->normal;
    const auto seen = cutter_->pick(frame_, pixels);
    if (!onlyCuts()) {
        sweep(seen, mask.mask, mask.depths, tool); // put back, or laid on, from each place of the floor
        return;
    }
    // The mask is flat: all its elements begin in the plane, and burn away what stands above it there too.
    const volume::GridGeometry& geometry = *cutter_->geometry;
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    const double limit = std::max(mask_.extent.x, mask_.extent.y) * glm::length(plane->right);
    double above = 0;
    std::vector<field::SurfacePoint> surface(places.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
        surface[n].voxel = glm::vec4(glm::vec3(voxelFromWorld * glm::dvec4(places[n], 1.0)), 1.0F);
        surface[n].normal = glm::vec4(plane->normal, 0.0);
        if (seen[n].voxel.w > 0.5F && mask.mask.values[n] > 0) {
            const double height = glm::dot(worldOf(seen[n], geometry) - plane->centre, plane->normal);
            above = std::max(above, std::min(height, limit));
        }
    }
    tool.sweep.outsideSteps = cut().radius + above / geometry.stepMm();
    sweep(surface, mask.mask, mask.depths, tool);
}

void PenStroke::sweep(std::span<const field::SurfacePoint> surface, const sculpt::MaskRaster& mask,
                      std::span<const float> depths, sculpt::ToolCut& tool) {
    tool.sweep.radius = cut().radius;
    tool.sweep.depths = depths;
    std::vector<glm::vec3> directions;
    std::vector<float> reach;
    if (how_ == sculpt::Combine::Restore) {
        directions = sculpt::toolDirections(surface, mask, *cutter_->geometry, tool.sweep);
        reach = cutter_->reachOf(frame_, surface, directions, depths, tool.sweep.radius);
        tool.sweep.directions = directions;
        tool.sweep.outwardSteps = reach;
    } else if (fills()) {
        tool.sweep.outwardSteps = depths; // as high as a cut would be deep
    }
    cutter_->tools.cut(target(), surface, mask, tool);
}

} // namespace vs::studio

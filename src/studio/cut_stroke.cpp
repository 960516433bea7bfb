// SPDX-License-Identifier: Apache-2.0
#include "studio/cut_stroke.h"

#include "gl/pass.h"
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

const gl::Texture& Cutter::snapshot() {
    const gl::Pass pass("sculpture snapshot");
    const gl::Texture& texels = sculpture->texels();
    if (!snapshot_) {
        snapshot_ = gl::Texture(texels.size(), texels.format(), gl::Filter::Linear, "sculpture at pen-down");
    }
    const Box3 changed = sculpture->changedSince(snapshotVersion_);
    if (!changed.isEmpty()) {
        snapshot_.copyFrom(texels, changed, changed.lo);
    }
    snapshotVersion_ = sculpture->version();
    copiedVoxels_ = changed.volume();
    return snapshot_;
}

const render::Macrocells& Cutter::snapshot(const render::Macrocells& macrocells) {
    macrocells_.copyFrom(macrocells);
    return macrocells_;
}

std::vector<float> Cutter::sculptureAsFloats() const { return sculpture->values(geometry->box()); }

CutStroke::CutStroke(Cutter& cutter, render::Picker& picker, const render::Frame& frame,
                     const Peel& operation)
    : cutter_(&cutter), picker_(&picker), frame_(frame), operation_(operation),
      sculptureVersion_(cutter.sculpture->version()), backup_(cutter.sculpture->texels()) {
    prepare(operation.mask);
    // The peel stays where it was drawn, so its surface is cast once.
    if (mask_.size.x > 0) {
        sculpt::ToolSweep sweep;
        sweep.direction = sculpt::ToolDirection::OwnNormal;
        sweep.radius = operation.radius;
        peel_.emplace(picker_->pickPoints(frame_, elementPixels(drawnAt_)), mask_, sweep, *cutter.geometry,
                      cutter.sculpture->isEmpty() ? nullptr : &cutter.snapshot());
    }
}

CutStroke::CutStroke(Cutter& cutter, render::Picker& picker, const render::Frame& frame,
                     const Drill& operation)
    : cutter_(&cutter), picker_(&picker), frame_(frame), operation_(operation),
      sculptureVersion_(cutter.sculpture->version()), backup_(cutter.sculpture->texels()) {
    std::get<Drill>(operation_).stroke.clear(); // filled again as the pen moves
    prepare(operation.mask);
    if (frame_.scene.sculpture != nullptr) {
        frame_.scene.sculpture = &cutter_->snapshot();
    }
    frame_.macrocells = &cutter_->snapshot(*frame_.macrocells);
}

void CutStroke::prepare(const Sketch& sketch) {
    auto outline = outlineOf(sketch);
    drawnAt_ = centreOf(outline);
    for (auto& point : outline) {
        point -= drawnAt_;
        extent_ = glm::max(extent_, 2.0 * glm::abs(point));
    }
    const double pixelMm = frame_.rays.pixelMm(cutter_->geometry->centreWorld());
    const double pitch = std::max(kElementSteps * cutter_->geometry->stepMm() / pixelMm,
                                  std::max(extent_.x, extent_.y) / kMaxElements);
    mask_ = sculpt::rasterize(outline, pitch);
}

std::vector<glm::vec2> CutStroke::elementPixels(glm::dvec2 centre) const {
    std::vector<glm::vec2> pixels;
    pixels.reserve(mask_.values.size());
    for (int j = 0; j < mask_.size.y; ++j) {
        for (int i = 0; i < mask_.size.x; ++i) {
            pixels.emplace_back(centre + mask_.origin + mask_.pitch * glm::dvec2(i, j));
        }
    }
    return pixels;
}

void CutStroke::peelTo(double layers) {
    Peel& op = std::get<Peel>(operation_);
    op.layers = std::max(layers, 0.0);
    if (peel_) {
        auto& tools = cutter_->tools;
        peel_->cutTo(op.layers, tools.radiator(), tools.generator(), *cutter_->sculpture, &backup_);
    }
}

void CutStroke::drillAt(const sculpt::PenPoint& pen) {
    Drill& op = std::get<Drill>(operation_);
    const sculpt::PenPoint from = op.stroke.empty() ? pen : op.stroke.back();
    op.stroke.push_back(pen);
    // Stamps a quarter of the mask apart leave no scallops along the stroke's sides.
    const double spacing = std::max(0.25 * std::min(extent_.x, extent_.y), 2.0);
    const int stamps = std::max(1, int(std::ceil(glm::length(pen.pixel - from.pixel) / spacing)));
    for (int i = 1; i <= stamps; ++i) {
        const double s = double(i) / stamps;
        stamp(glm::mix(from.pixel, pen.pixel, s), glm::mix(from.pressure, pen.pressure, s));
    }
}

void CutStroke::stampWhereDrawn() { stamp(drawnAt_, 1); }

void CutStroke::stamp(glm::dvec2 centre, double pressure) {
    const Drill& op = std::get<Drill>(operation_);
    // Beside the picture there is nothing to cut, however long the stroke.
    const bool isInPicture = glm::all(glm::greaterThan(centre + extent_, glm::dvec2(0))) &&
                             glm::all(glm::lessThan(centre - extent_, glm::dvec2(frame_.rays.size)));
    if (mask_.size.x == 0 || pressure <= 0 || !isInPicture) {
        return;
    }
    const auto surface = picker_->pickPoints(frame_, elementPixels(centre));
    sculpt::ToolCut cut;
    cut.sweep.direction = sculpt::ToolDirection::Common;
    cut.sweep.directionWorld = frame_.rays.through(centre).direction;
    cut.sweep.depthSteps = op.depthMax * std::min(pressure, 1.0);
    cut.sweep.radius = op.radius;
    cutter_->tools.cut(*cutter_->sculpture, surface, mask_, cut, &backup_);
}

void CutStroke::discard() {
    if (!backup_.isEmpty()) {
        cutter_->sculpture->refresh(backup_.restore());
    }
}

} // namespace vs::studio

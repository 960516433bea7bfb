// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/peel_stroke.h"

namespace vs::studio {

namespace {

sculpt::ToolSweep sweepOf(const Peel& op) {
    sculpt::ToolSweep sweep;
    sweep.direction = sculpt::ToolDirection::OwnNormal;
    sweep.radius = op.radius;
    return sweep;
}

} // namespace

PeelStroke::PeelStroke(Cutter& cutter, const MakeFrame& makeFrame, const Peel& operation)
    : CutStroke(cutter, operation, operation.restores), frame_(makeFrame()),
      mask_(operation.mask, frame_, *cutter.geometry) {
    if (mask_.raster.values.empty()) {
        return;
    }
    const gl::Texture* before = cutter.sculpture->isEmpty() ? nullptr : &cutter.snapshot();
    cutter.keepSurfaces();
    surface_ = cutter.pick(frame_, pixelsOf(mask_.raster, mask_.drawnAt));
    if (onlyCuts()) {
        layers_.emplace(surface_, mask_.raster, sweepOf(operation), *cutter.geometry, before);
    } else {
        directions_ = sculpt::toolDirections(surface_, mask_.raster, *cutter.geometry, sweepOf(operation));
        frame_.scene.sculpture = before;
    }
}

void PeelStroke::peelTo(double layers) {
    Peel& op = std::get<Peel>(operation_);
    op.layers = std::max(layers, 0.0);
    auto& tools = cutter_->tools;
    const double depth = op.layers * cutter_->toolSteps();
    if (layers_ && (cutter_->cutsFiner() || cutsFill() || takesFill())) {
        discard();
        layers_->cutAtOnce(depth, tools.radiator(), tools.generator(), target());
    } else if (layers_) {
        layers_->cutTo(depth, tools.radiator(), tools.generator(), *cutter_->sculpture, &backup_);
    } else {
        restoreTo(op);
    }
}

// How far layers can be put back differs from place to place, so each time all of them are put back anew; of
// material as many are laid on.
void PeelStroke::restoreTo(const Peel& op) {
    discard();
    if (surface_.empty() || op.layers <= 0) {
        return;
    }
    const double depth = op.layers * cutter_->toolSteps();
    const std::vector<float> depths(surface_.size(), float(depth));
    const auto reach = fills() ? depths : cutter_->reachOf(frame_, surface_, directions_, depths, op.radius);
    sculpt::ToolCut cut{sweepOf(op), how_};
    cut.sweep.depthSteps = depth;
    cut.sweep.directions = directions_;
    cut.sweep.outwardSteps = reach;
    cutter_->tools.cut(target(), surface_, mask_.raster, cut);
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "studio/peel_stroke.h"

namespace vs::studio {

PeelStroke::PeelStroke(Cutter& cutter, const LookAgain& look, const Peel& operation)
    : CutStroke(cutter, operation, operation.restores), frame_(look()),
      mask_(operation.mask, frame_, *cutter.geometry) {
    if (mask_.raster.values.empty()) {
        return;
    }
    surface_ = cutter.picker.pickPoints(frame_, mask_.at(mask_.drawnAt, 1).pixels());
    if (operation.restores) {
        sculpt::ToolSweep sweep;
        sweep.direction = sculpt::ToolDirection::OwnNormal;
        directions_ = sculpt::toolDirections(surface_, mask_.raster, *cutter.geometry, sweep);
        if (frame_.scene.sculpture != nullptr) {
            frame_.scene.sculpture = &cutter.snapshot();
        }
    }
}

void PeelStroke::peelTo(double layers) {
    Peel& op = std::get<Peel>(operation_);
    op.layers = std::max(layers, 0.0);
    discard();
    if (surface_.empty() || op.layers <= 0) {
        return;
    }
    sculpt::ToolCut cut{{}, how_};
    cut.sweep.direction = sculpt::ToolDirection::OwnNormal;
    cut.sweep.depthSteps = op.layers;
    cut.sweep.radius = op.radius;
    std::vector<float> reach;
    if (op.restores) {
        const std::vector<float> depths(surface_.size(), float(op.layers));
        reach = cutter_->restoreReach.measure(frame_.scene, surface_, directions_, depths, op.radius);
        cut.sweep.directions = directions_;
        cut.sweep.outwardSteps = reach;
    }
    cutter_->tools.cut(*cutter_->sculpture, surface_, mask_.raster, cut, &backup_);
}

} // namespace vs::studio

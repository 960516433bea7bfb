// SPDX-License-Identifier: Apache-2.0
#include "tools/scissors_tool.h"

#include "model/studio/studio_controller.h"
#include "tools/sketch_hints.h"

namespace vs::desktop {

QString ScissorsTool::hint() const { return withTarget(doing()); }

QString ScissorsTool::doing() const {
    if (isSketching_) {
        return sketchHint(pad_, actsOnSegment() ? (adds() ? SketchEnd::Add : SketchEnd::Remove)
                                : restores()    ? SketchEnd::Restore
                                                : SketchEnd::Cut);
    }
    if (actsOnSegment()) {
        return drawHint(cutsOutside_ ? tr("Draw around a region: the scissors take everything outside it.")
                                     : tr("Draw around what the scissors should take."));
    }
    if (restores()) {
        return drawHint(cutsOutside_ ? tr("Draw around a region: everything outside it is put back.")
                                     : tr("Draw around what should be put back."));
    }
    return drawHint(cutsOutside_ ? tr("Draw around what should stay: everything outside it is cut.")
                                 : tr("Draw around what should go."));
}

Overlays ScissorsTool::overlays() const {
    if (!isSketching_) {
        return {};
    }
    Overlays overlays = sketchOverlays(pad_, cuttingTint());
    if (cutsOutside_ && pad_.isOfUse()) {
        QPainterPath& region = overlays.front().path;
        region.addRect(region.boundingRect().adjusted(-1e4, -1e4, 1e4, 1e4));
    }
    return overlays;
}

void ScissorsTool::setCutsOutside(bool outside) {
    cutsOutside_ = outside;
    tell();
}

void ScissorsTool::setDepth(std::optional<double> steps) {
    depth_ = steps;
    tell();
}

void ScissorsTool::press(const Pen& pen) {
    if (!isSketching_) { // else the next corner of a polyline
        pad_.begin(studio_.hand().shape(), pen.position, studio_.hand().stencil());
    }
    pad_.press(pen);
    isSketching_ = true;
    emit overlayChanged();
}

void ScissorsTool::move(const Pen& pen) {
    if (isSketching_) {
        pad_.extend(pen.position);
        emit overlayChanged();
    }
}

void ScissorsTool::release(const Pen& pen) {
    if (!isSketching_) {
        return;
    }
    if (pad_.end(pen.position)) {
        cutSketch();
    }
    emit overlayChanged();
}

bool ScissorsTool::accept() {
    const bool isDone = isSketching_ && pad_.finish();
    if (isDone) {
        cutSketch();
    }
    return isDone;
}

void ScissorsTool::cutSketch() {
    isSketching_ = false;
    emit overlayChanged();
    if (!pad_.isOfUse()) {
        return;
    }
    studio::Scissors scissors;
    scissors.outline = pad_.sketch(studio_.view().devicePerLogical());
    scissors.cutsOutside = cutsOutside_;
    scissors.depth = depth_;
    scissors.radius = radius();
    scissors.restores = restores();
    scissors.canvas = studio_.view().canvas();
    studio_.editor().cut(scissors);
}

void ScissorsTool::clear() {
    isSketching_ = false;
    pad_.clear();
    emit overlayChanged();
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "tools/scissors_tool.h"

#include "model/studio/studio_controller.h"
#include "tools/kinds/sketch_hints.h"

namespace vs::desktop {

QString ScissorsTool::hint() const { return withTarget(doing()); }

QString ScissorsTool::doing() const {
    if (isSketching()) {
        return sketchHint(pad(), actsOnMaterial()  ? (isReversed() ? SketchEnd::Remove : SketchEnd::Fill)
                                 : actsOnSegment() ? (adds() ? SketchEnd::Add : SketchEnd::Remove)
                                 : restores()      ? SketchEnd::Restore
                                                   : SketchEnd::Cut);
    }
    if (actsOnMaterial()) {
        return drawHint(isReversed()
                            ? tr("Draw around the material that should go.")
                            : tr("Draw around a hole, on the surface beside it: it is filled up to that."));
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
    if (!isSketching()) {
        return {};
    }
    Overlays overlays = sketchOverlays(pad(), cuttingTint());
    if (cutsOutside_ && pad().isOfUse()) {
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
    if (!picksValue(pen)) {
        SketchTool::press(pen);
    }
}

void ScissorsTool::takeSketch() {
    if (!studio_.editor().prepareMaterial()) {
        return;
    }
    studio::Scissors scissors;
    scissors.outline = sketch();
    scissors.cutsOutside = cutsOutside_ && !actsOnMaterial();
    scissors.depth = depth_;
    scissors.radius = radius();
    scissors.restores = restores();
    scissors.canvas = studio_.view().canvas();
    studio_.editor().cut(scissors);
}

} // namespace vs::desktop

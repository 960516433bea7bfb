// SPDX-License-Identifier: Apache-2.0
#include "scissors_tool.h"

#include "studio_controller.h"

namespace vs::desktop {

QString ScissorsTool::hint() const { return doing() + segmentHint(); }

QString ScissorsTool::doing() const {
    if (isDown_) {
        return tr("Let go to close the stroke and cut. Esc drops it.");
    }
    if (restores()) {
        return cutsOutside_ ? tr("Draw around a region: everything outside it is put back when you let go.")
                            : tr("Draw around what should be put back; it is when you let go.");
    }
    return cutsOutside_ ? tr("Draw around what should stay: everything outside it is cut when you let go.")
                        : tr("Draw around what should go: it is cut when you let go.");
}

Overlays ScissorsTool::overlays() const {
    if (!isDown_) {
        return {};
    }
    QPainterPath region = pad_.area();
    if (cutsOutside_) {
        region.addRect(region.boundingRect().adjusted(-1e4, -1e4, 1e4, 1e4));
    }
    return {{region, cuttingTint(), Overlay::kMaskFill, 1}, {pad_.outline(), Overlay::Tint::Pen}};
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
    if (!isDown_) { // else the next corner of a polyline
        pad_.begin(studio_.shape(), pen.position, studio_.stencil());
    }
    isDown_ = true;
    emit overlayChanged();
}

void ScissorsTool::move(const Pen& pen) {
    if (isDown_) {
        pad_.extend(pen.position);
        emit overlayChanged();
    }
}

void ScissorsTool::release(const Pen& pen) {
    if (!isDown_) {
        return;
    }
    if (!pad_.end(pen.position)) {
        return;
    }
    isDown_ = false;
    emit overlayChanged();
    if (!pad_.hasArea()) {
        return;
    }
    studio::Scissors scissors;
    scissors.outline = pad_.sketch(studio_.devicePerLogical());
    scissors.cutsOutside = cutsOutside_;
    scissors.depth = depth_;
    scissors.radius = radius();
    scissors.restores = restores();
    scissors.canvas = studio_.canvas();
    studio_.cut(scissors);
}

void ScissorsTool::clear() {
    isDown_ = false;
    pad_.clear();
    emit overlayChanged();
}

} // namespace vs::desktop

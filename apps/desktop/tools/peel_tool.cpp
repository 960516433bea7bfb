// SPDX-License-Identifier: Apache-2.0
#include "tools/peel_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/live_stroke.h"

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr double kLayersPerPixel = 0.1; // thesis, section 4.4: 10 pixels are one layer
}

MaskTool::Words PeelTool::words() const {
    const QString draw = tr("Draw an outline around the region to peel.");
    if (restores()) {
        return {draw,
                tr("Press inside the mask and drag down to put layers back on. Draw outside it for a new "
                   "mask. Esc clears it."),
                tr("Down puts back, up takes off: %1 layers. Let go to keep, Esc to undo.")
                    .arg(wanted_, 0, 'f', 1)};
    }
    return {draw,
            tr("Press inside the mask and drag down to peel. Draw outside it for a new mask. Esc clears it."),
            tr("Down peels, up puts back: %1 layers. Let go to keep, Esc to undo.").arg(wanted_, 0, 'f', 1)};
}

Qt::CursorShape PeelTool::cursor() const {
    return state() == State::Cutting || (state() == State::Ready && isInside_) ? Qt::SizeVerCursor
                                                                               : Qt::CrossCursor;
}

bool PeelTool::isForMask(const Pen& pen) const { return mask().contains(pen.position); }

studio::Operation PeelTool::stroke(const studio::Sketch& mask, const studio::Canvas& canvas) const {
    return studio::Peel{mask, 0, radius(), restores(), canvas};
}

void PeelTool::begin(const Pen& pen) {
    pressed_ = pen.position;
    wanted_ = applied_ = 0;
}

void PeelTool::lead(const Pen& pen) {
    wanted_ = std::max(0.0, kLayersPerPixel * (pen.position.y() - pressed_.y()));
    studio_.host().wake();
    emit layersChanged();
    emit overlayChanged();
}

bool PeelTool::finish(const Pen& pen) {
    lead(pen);
    advance();
    return applied_ > 0;
}

void PeelTool::release(const Pen& pen) {
    const bool wasSketching = isSketching();
    MaskTool::release(pen);
    if (wasSketching) {
        hover(pen);
    }
}

void PeelTool::takeSketch() {
    isInside_ = false; // until the pen says where it is
}

void PeelTool::hover(const Pen& pen) {
    if (isSketching()) {
        MaskTool::hover(pen);
        return;
    }
    const bool isInside = state() == State::Ready && isForMask(pen);
    if (isInside != isInside_) {
        isInside_ = isInside;
        emit overlayChanged();
    }
}

void PeelTool::clear() {
    const bool wasPeeling = state() == State::Cutting;
    MaskTool::clear();
    if (wasPeeling) {
        wanted_ = applied_ = 0;
        emit layersChanged();
    }
}

void PeelTool::advance() {
    if (state() == State::Cutting && wanted_ != applied_ &&
        update([&](studio::Document& document) { document.stroke().peelTo(wanted_); })) {
        applied_ = wanted_;
    }
}

} // namespace vs::desktop

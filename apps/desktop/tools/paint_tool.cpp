// SPDX-License-Identifier: Apache-2.0
#include "tools/paint_tool.h"

#include "model/segments/growth_controller.h"
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/camera_tool.h"
#include "tools/kinds/sketch_hints.h"

#include <algorithm>

namespace vs::desktop {

PaintTool::PaintTool(StudioController& studio, CameraTool& camera) : StudioTool(studio), camera_(camera) {}

QString PaintTool::hint() const {
    if (!studio_.slices().isAnyShown()) {
        return tr("Painting goes on the slices: show them with F4. Here dragging turns the volume.");
    }
    if (QString locked = lockedHint(studio_); !locked.isEmpty()) {
        return locked;
    }
    return isToAdd_ ? tr("Paint on a slice to add to the segment; the right button or Ctrl removes. [ and ] "
                         "change the "
                         "brush, Shift leads the crosshair.")
                    : tr("Paint on a slice to remove from the segment; the right button or Ctrl adds. [ and "
                         "] change "
                         "the brush, Shift leads the crosshair.");
}

Qt::CursorShape PaintTool::cursor() const { return camera_.cursor(); }
void PaintTool::press(const Pen& pen) { camera_.press(pen); }
void PaintTool::move(const Pen& pen) { camera_.move(pen); }
void PaintTool::release(const Pen& pen) { camera_.release(pen); }

void PaintTool::clear() {
    camera_.clear();
    emit overlayChanged();
}

void PaintTool::setRadiusMm(double mm) {
    radiusMm_ = std::clamp(mm, kLeastMm, kMostMm);
    emit settingsChanged();
}

void PaintTool::setToAdd(bool isToAdd) {
    isToAdd_ = isToAdd;
    emit settingsChanged();
}

void PaintTool::setBall(bool isBall) {
    isBall_ = isBall;
    emit settingsChanged();
}

void PaintTool::setInRangeOnly(bool isInRangeOnly) {
    isInRangeOnly_ = isInRangeOnly;
    emit settingsChanged();
}

void PaintTool::paint(studio::Trail trail, bool isReversed) {
    if (isBall_) {
        trail.axis.reset();
    }
    studio::PaintSegment paint{isToAdd_ != isReversed, std::move(trail), {}};
    if (isInRangeOnly_) {
        const auto growth = studio_.growth().status();
        paint.range =
            growth.hasSeeds && growth.range.width() > 0 ? growth.range : studio_.view().visibleRange();
    }
    studio_.editor().apply(paint);
}

} // namespace vs::desktop

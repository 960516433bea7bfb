// SPDX-License-Identifier: Apache-2.0
#include "tools/keep_tool.h"

#include "model/studio/studio_controller.h"

namespace vs::desktop {

KeepTool::KeepTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

QString KeepTool::hint() const {
    if (pressed_) {
        return tr("Let go to cut away all that is not connected to what is under the ring. Esc changes "
                  "nothing.");
    }
    return tr("Click the object to keep: all that is visible and not connected to it is cut away.");
}

Overlays KeepTool::overlays() const {
    if (!pressed_) {
        return {};
    }
    constexpr double kRing = 9;
    QPainterPath ring;
    ring.addEllipse(*pressed_, kRing, kRing);
    return {{ring, Overlay::Tint::Idle, Overlay::kMaskFill}};
}

void KeepTool::press(const Pen& pen) {
    pressed_ = pen.position;
    emit overlayChanged();
}

void KeepTool::release(const Pen&) {
    if (!pressed_) {
        return;
    }
    studio::KeepConnected keep;
    keep.pixel = glm::dvec2(pressed_->x(), pressed_->y()) * studio_.view().devicePerLogical();
    keep.connectivity = joinsCorners_ ? 26 : 6;
    keep.canvas = studio_.view().canvas();
    clear();
    studio_.editor().apply(keep);
}

void KeepTool::clear() {
    pressed_.reset();
    emit overlayChanged();
}

} // namespace vs::desktop

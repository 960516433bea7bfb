// SPDX-License-Identifier: Apache-2.0
#include "tools/kinds/click_tool.h"

#include "model/studio/studio_controller.h"

namespace vs::desktop {

Overlays ClickTool::overlays() const {
    if (!pressed_) {
        return {};
    }
    constexpr double kRing = 9;
    QPainterPath ring;
    ring.addEllipse(*pressed_, kRing, kRing);
    return {{ring, tint(), Overlay::kMaskFill}};
}

void ClickTool::press(const Pen& pen) {
    pressed_ = pen.position;
    emit overlayChanged();
}

void ClickTool::release(const Pen&) {
    if (!pressed_) {
        return;
    }
    const QPointF at = *pressed_;
    clear();
    click(glm::dvec2(at.x(), at.y()) * studio_.view().devicePerLogical());
}

void ClickTool::clear() {
    pressed_.reset();
    emit overlayChanged();
}

} // namespace vs::desktop

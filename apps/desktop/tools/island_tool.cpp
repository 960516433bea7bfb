// SPDX-License-Identifier: Apache-2.0
#include "tools/island_tool.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/sketch_hints.h"

namespace vs::desktop {

IslandTool::IslandTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

QString IslandTool::hint() const {
    if (const QString locked = lockedHint(studio_); !locked.isEmpty()) {
        return locked;
    }
    const auto& working = studio_.segments().list().working();
    const QString name = QString::fromStdString(working.name);
    if (studio_.segments().voxels(working.label) == 0) {
        return tr("%1 is empty: there is no part of it to click.").arg(name);
    }
    if (pressed_) {
        return keeps_ ? tr("Let go to keep only the part under the ring. Esc changes nothing.")
                      : tr("Let go to drop the part under the ring. Esc changes nothing.");
    }
    return keeps_
               ? tr("Click a part of %1: all that is not connected to it goes. R drops parts again.")
                     .arg(name)
               : tr("Click a part of %1 to drop it, with all that is connected to it. R keeps only the part "
                    "clicked.")
                     .arg(name);
}

Overlays IslandTool::overlays() const {
    if (!pressed_) {
        return {};
    }
    constexpr double kRing = 9;
    QPainterPath ring;
    ring.addEllipse(*pressed_, kRing, kRing);
    return {{ring, keeps_ ? Overlay::Tint::Idle : Overlay::Tint::Cutting, Overlay::kMaskFill}};
}

void IslandTool::setReversed(bool reversed) {
    if (reversed != keeps_) {
        keeps_ = reversed;
        emit settingsChanged();
        emit overlayChanged();
    }
}

void IslandTool::press(const Pen& pen) {
    pressed_ = pen.position;
    emit overlayChanged();
}

void IslandTool::release(const Pen&) {
    if (!pressed_) {
        return;
    }
    studio::EditSegment edit;
    edit.kind = keeps_ ? studio::EditSegment::Kind::KeepIsland : studio::EditSegment::Kind::DropIsland;
    edit.pixel = glm::dvec2(pressed_->x(), pressed_->y()) * studio_.view().devicePerLogical();
    edit.canvas = studio_.view().canvas();
    clear();
    studio_.segments().perform(edit);
}

void IslandTool::clear() {
    pressed_.reset();
    emit overlayChanged();
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "tools/island_tool.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/kinds/sketch_hints.h"

namespace vs::desktop {

QString IslandTool::hint() const {
    if (QString locked = lockedHint(studio_); !locked.isEmpty()) {
        return locked;
    }
    const auto& working = studio_.segments().list().working();
    const QString name = QString::fromStdString(working.name);
    if (studio_.segments().voxels(working.label) == 0) {
        return tr("%1 is empty: there is no part of it to click.").arg(name);
    }
    if (isBusy()) {
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

void IslandTool::setReversed(bool reversed) {
    if (reversed != keeps_) {
        keeps_ = reversed;
        emit settingsChanged();
        emit overlayChanged();
    }
}

void IslandTool::click(glm::dvec2 pixel) {
    studio::EditSegment edit;
    edit.kind = keeps_ ? studio::EditSegment::Kind::KeepIsland : studio::EditSegment::Kind::DropIsland;
    edit.pixel = pixel;
    edit.canvas = studio_.view().canvas();
    studio_.segments().perform(edit);
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "tools/kinds/cut_tool.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/kinds/sketch_hints.h"

namespace vs::desktop {

bool CutTool::actsOnSegment() const { return canActOnSegment() && studio_.hand().brushesSegment(); }

QString CutTool::withTarget(const QString& hint) const {
    if (!actsOnSegment()) {
        return hint;
    }
    if (QString locked = lockedHint(studio_); !locked.isEmpty()) {
        return locked;
    }
    if (isSketching()) {
        return hint;
    }
    const QString name = QString::fromStdString(studio_.segments().list().working().name);
    return hint + " " +
           (adds() ? tr("What it takes is added to %1, the scan stays. R removes.").arg(name)
                   : tr("What it takes is removed from %1, the scan stays. R adds.").arg(name));
}

QString CutTool::drawHint(const QString& what) const {
    return actsOnSegment() ? what : what + " " + howToDraw(studio_.hand().shape());
}

void CutTool::setRestores(bool restores) {
    if (restores != restores_) {
        restores_ = restores;
        tell();
    }
}

void CutTool::setRadius(int steps) {
    if (steps != radius_) {
        radius_ = steps;
        tell();
    }
}

void CutTool::tell() {
    emit settingsChanged();
    emit overlayChanged();
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "tools/kinds/cut_tool.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "studio/document/surface_queries.h"
#include "tools/kinds/sketch_hints.h"

namespace vs::desktop {

bool CutTool::actsOnSegment() const {
    return canActOnSegment() && studio_.hand().target() == Hand::Target::Segment;
}

bool CutTool::actsOnMaterial() const {
    return canActOnMaterial() && studio_.hand().target() == Hand::Target::Material;
}

bool CutTool::picksValue(const Pen& pen) {
    const bool isThere = studio_.hand().material() <= int(studio_.host().facts()->materials->size());
    if (!actsOnMaterial() || !studio_.hand().picksValue() || !isThere) {
        return false;
    }
    studio_.hand().setPicksValue(false);
    std::optional<studio::Probe> probe;
    const glm::dvec2 pixel =
        glm::dvec2(pen.position.x(), pen.position.y()) * studio_.view().devicePerLogical();
    studio_.host().workLong(
        [&] { probe = studio_.host().document()->surface().probe(pixel, studio_.view().canvas().viewport); });
    if (!probe) {
        studio_.host().say(tr("Nothing is seen there whose value could be taken"));
        return true;
    }
    studio::SetMaterial material;
    material.number = studio_.hand().material();
    material.value = probe->value;
    studio_.editor().apply(material);
    return true;
}

QString CutTool::withTarget(const QString& hint) const {
    if (actsOnMaterial() && studio_.hand().picksValue()) {
        return tr("Click where the scan has the value that the material should have.");
    }
    if (actsOnMaterial()) {
        return !saysWhatItFills() || isSketching()
                   ? hint
                   : hint + " " +
                         (isReversed() ? tr("It takes material away, the scan stays. R fills.")
                                       : tr("It adds material, outward from the surface. R takes it away."));
    }
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

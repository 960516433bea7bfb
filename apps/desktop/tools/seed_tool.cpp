// SPDX-License-Identifier: Apache-2.0
#include "tools/seed_tool.h"

#include "model/segments/growth_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/kinds/sketch_hints.h"

namespace vs::desktop {

QString SeedTool::hint() const {
    const QString locked = lockedHint(studio_);
    return locked.isEmpty() ? doing() : locked;
}

QString SeedTool::doing() const {
    if (isSketching()) {
        return sketchHint(pad(), isReversed_ ? SketchEnd::Absorb : SketchEnd::Seed);
    }
    const bool starts = studio_.growth().isAutoStart();
    const QString how = " " + howToDraw(studio_.hand().shape(), SketchPad::Needs::Line) + " ";
    if (isReversed_) {
        return (starts ? tr("Draw on the segment: it is absorbed from there outward until you pause.")
                       : tr("Draw on the segment: it is absorbed there; Step and Play go on outward.")) +
               how + tr("R seeds again.");
    }
    return (starts ? tr("Draw on what should be segmented: it grows from there.")
                   : tr("Draw on what should be segmented, then press Play.")) +
           how + tr("More strokes add to it.");
}

Overlays SeedTool::overlays() const {
    return isSketching()
               ? sketchOverlays(pad(), isReversed_ ? Overlay::Tint::Cutting : Overlay::Tint::Seed, width_)
               : Overlays{};
}

void SeedTool::taken() { studio_.growth().prepare(); }
void SeedTool::putDown() { studio_.growth().giveBack(); }

void SeedTool::setReversed(bool reversed) {
    if (reversed != isReversed_) {
        isReversed_ = reversed;
        studio_.growth().setStrokesAbsorb(reversed);
        emit settingsChanged();
        emit overlayChanged();
    }
}

void SeedTool::takeSketch() {
    const auto fill = [&](auto stroke) {
        stroke.strokes.push_back(sketch());
        stroke.widthPixels = width_ * studio_.view().devicePerLogical().y;
        stroke.canvas = studio_.view().canvas();
        return stroke;
    };
    if (isReversed_) {
        studio_.growth().absorb(fill(studio::Absorb{}));
    } else {
        studio_.growth().addSeeds(fill(studio::Seed{}));
    }
}

} // namespace vs::desktop

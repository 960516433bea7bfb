// SPDX-License-Identifier: Apache-2.0
#include "tools/seed_tool.h"

#include "model/segments/growth_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/sketch_hints.h"

namespace vs::desktop {

SeedTool::SeedTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

QString SeedTool::hint() const {
    const QString locked = lockedHint(studio_);
    return locked.isEmpty() ? doing() : locked;
}

QString SeedTool::doing() const {
    if (isSketching_) {
        return sketchHint(pad_, isReversed_ ? SketchEnd::Absorb : SketchEnd::Seed);
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
    return isSketching_
               ? sketchOverlays(pad_, isReversed_ ? Overlay::Tint::Cutting : Overlay::Tint::Seed, width_)
               : Overlays{};
}

void SeedTool::setReversed(bool reversed) {
    if (reversed != isReversed_) {
        isReversed_ = reversed;
        studio_.growth().setStrokesAbsorb(reversed);
        emit settingsChanged();
        emit overlayChanged();
    }
}

void SeedTool::press(const Pen& pen) {
    if (!isSketching_) { // else the next corner of a polyline
        pad_.begin(studio_.hand().shape(), pen.position, studio_.hand().stencil(), SketchPad::Needs::Line);
    }
    pad_.press(pen);
    isSketching_ = true;
    emit overlayChanged();
}

void SeedTool::move(const Pen& pen) {
    if (isSketching_) {
        pad_.extend(pen.position);
        emit overlayChanged();
    }
}

void SeedTool::release(const Pen& pen) {
    if (!isSketching_) {
        return;
    }
    if (pad_.end(pen.position)) {
        takeStroke();
    }
    emit overlayChanged();
}

bool SeedTool::accept() {
    const bool isDone = isSketching_ && pad_.finish();
    if (isDone) {
        takeStroke();
    }
    return isDone;
}

void SeedTool::takeStroke() {
    isSketching_ = false;
    emit overlayChanged();
    if (!pad_.isOfUse()) {
        return;
    }
    const glm::dvec2 scale = studio_.view().devicePerLogical();
    const auto fill = [&](auto stroke) {
        stroke.strokes.push_back(pad_.sketch(scale));
        stroke.widthPixels = width_ * scale.y;
        stroke.canvas = studio_.view().canvas();
        return stroke;
    };
    if (isReversed_) {
        studio_.growth().absorb(fill(studio::Absorb{}));
    } else {
        studio_.growth().addSeeds(fill(studio::Seed{}));
    }
}

void SeedTool::clear() {
    isSketching_ = false;
    pad_.clear();
    emit overlayChanged();
}

} // namespace vs::desktop

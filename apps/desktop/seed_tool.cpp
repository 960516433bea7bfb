// SPDX-License-Identifier: Apache-2.0
#include "seed_tool.h"

#include "growth_controller.h"
#include "studio_controller.h"

namespace vs::desktop {

SeedTool::SeedTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

QString SeedTool::hint() const {
    if (isDown_) {
        return isReversed_ ? tr("Let go to absorb from here. Esc drops the stroke.")
                           : tr("Let go to place the seeds. Esc drops the stroke.");
    }
    if (isReversed_) {
        return studio_.growth().isAutoStart() ? tr("Draw on the segment: it is absorbed from there outward "
                                                   "until you pause. R seeds again.")
                                              : tr("Draw on the segment to absorb it there; Step and Play go "
                                                   "on outward. R seeds again.");
    }
    return studio_.growth().isAutoStart()
               ? tr("Draw on what should be segmented; it starts to grow when you let go. More strokes add "
                    "to it.")
               : tr("Draw on what should be segmented, then press Play. More strokes add to it.");
}

Overlays SeedTool::overlays() const {
    if (!isDown_) {
        return {};
    }
    const auto tint = isReversed_ ? Overlay::Tint::Cutting : Overlay::Tint::Seed;
    if (studio_.shape() == studio::Shape::FreeForm) {
        return {{pad_.outline(), tint, 0, width_}};
    }
    return {{pad_.area(), tint, Overlay::kMaskFill}};
}

void SeedTool::setReversed(bool reversed) {
    if (reversed != isReversed_) {
        isReversed_ = reversed;
        emit settingsChanged();
        emit overlayChanged();
    }
}

void SeedTool::press(const Pen& pen) {
    if (!isDown_) { // else the next corner of a polyline
        pad_.begin(studio_.shape(), pen.position, studio_.stencil());
    }
    isDown_ = true;
    emit overlayChanged();
}

void SeedTool::move(const Pen& pen) {
    if (isDown_) {
        pad_.extend(pen.position);
        emit overlayChanged();
    }
}

void SeedTool::release(const Pen& pen) {
    if (!isDown_) {
        return;
    }
    if (!pad_.end(pen.position)) {
        return;
    }
    isDown_ = false;
    emit overlayChanged();
    if (studio_.shape() != studio::Shape::FreeForm && !pad_.hasArea()) {
        return;
    }
    const glm::dvec2 scale = studio_.devicePerLogical();
    const auto fill = [&](auto stroke) {
        stroke.strokes.push_back(pad_.sketch(scale));
        stroke.widthPixels = width_ * scale.y;
        stroke.canvas = studio_.canvas();
        return stroke;
    };
    if (isReversed_) {
        studio_.growth().absorb(fill(studio::Absorb{}));
    } else {
        studio_.growth().addSeeds(fill(studio::Seed{}));
    }
}

void SeedTool::clear() {
    isDown_ = false;
    pad_.clear();
    emit overlayChanged();
}

} // namespace vs::desktop

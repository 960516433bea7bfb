// SPDX-License-Identifier: Apache-2.0
#include "seed_tool.h"

#include "growth_controller.h"
#include "studio_controller.h"

namespace vs::desktop {

SeedTool::SeedTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

QString SeedTool::hint() const {
    if (isDown_) {
        return tr("Let go to place the seeds. Esc drops the stroke.");
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
    if (studio_.shape() == studio::Shape::FreeForm) {
        return {{pad_.outline(), Overlay::Tint::Seed, 0, width_}};
    }
    return {{pad_.area(), Overlay::Tint::Seed, Overlay::kMaskFill}};
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
    studio::Seed seed;
    const glm::dvec2 scale = studio_.devicePerLogical();
    seed.strokes.push_back(pad_.sketch(scale));
    seed.widthPixels = width_ * scale.y;
    seed.canvas = studio_.canvas();
    studio_.growth().addSeeds(seed);
}

void SeedTool::clear() {
    isDown_ = false;
    pad_.clear();
    emit overlayChanged();
}

} // namespace vs::desktop

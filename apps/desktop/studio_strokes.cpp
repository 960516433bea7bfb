// SPDX-License-Identifier: Apache-2.0
// Strokes: on the scan, or on the segment at work.
#include "cut_tool.h"
#include "growth_controller.h"
#include "studio_controller.h"

namespace vs::desktop {

bool StudioController::beginStroke(
    const std::function<void(studio::Document&, const studio::Canvas&)>& begin) {
    growth_->pause();
    const auto on = canvas();
    return workLong([&] { begin(*document_, on); });
}

void StudioController::endStroke(bool keep) {
    if (document_ == nullptr || !document_->isStrokeOpen()) {
        return;
    }
    if (keep && cutTool() != nullptr && cutTool()->actsOnSegment()) {
        const studio::Operation stroke = document_->openStroke(); // it has shown what it takes
        workLong([&] { document_->discardStroke(); });
        cut(stroke);
        return;
    }
    if (keep) {
        perform([&] { return document_->commitStroke(); });
    } else if (workLong([&] { document_->discardStroke(); })) {
        say(tr("Nothing was changed"));
    }
    wake();
    emit changed();
}

bool StudioController::cut(const studio::Operation& stroke) {
    if (cutTool() == nullptr || !cutTool()->actsOnSegment()) {
        return apply(stroke);
    }
    studio::BrushSegment brush;
    brush.isToAdd = cutTool()->adds();
    std::visit(
        [&](const auto& drawn) {
            if constexpr (std::is_constructible_v<decltype(brush.stroke), decltype(drawn)>) {
                brush.stroke = drawn;
            }
        },
        stroke);
    return apply(brush);
}

void StudioController::setBrushesSegment(bool on) {
    brushesSegment_ = on;
    emit overlayChanged(); // the hint
    emit changed();
}

} // namespace vs::desktop

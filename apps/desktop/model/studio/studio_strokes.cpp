// SPDX-License-Identifier: Apache-2.0
// Strokes on the scan or on the segment at work, and pasting what they cut out.
#include "model/segments/growth_controller.h"
#include "model/studio/free_room.h"
#include "model/studio/studio_controller.h"
#include "model/studio/tool.h"

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
    if (keep && tool_->actsOnSegment()) {
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
    if (!tool_->actsOnSegment()) {
        return apply(stroke);
    }
    studio::BrushSegment brush;
    brush.isToAdd = tool_->adds();
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

bool StudioController::paste() {
    if (document_ == nullptr || isLoading()) {
        return false;
    }
    render::Placement place;
    render::Camera camera;
    bool isSomething = false;
    flushView();
    const bool isPlaced = workLong([&] {
        FreeRoom room(view_.camera, *geometry(), picture_->viewport());
        room.take(document_->remainingCells());
        for (std::size_t part = 0; part < view_.pasted.size(); ++part) {
            room.take(document_->partCells(part), view_.pasted[part]);
        }
        const auto part = document_->partCells(document_->pastedParts());
        isSomething = !part.empty();
        if (isSomething) {
            place = room.find(part);
            room.take(part, place);
            camera = room.cameraOnAll();
        }
    });
    if (isPlaced && !isSomething) {
        say(tr("Nothing to paste: nothing visible was cut since the last paste"));
        return false;
    }
    if (!isPlaced || !apply(studio::Paste{place})) {
        return false;
    }
    auto view = view_;
    view.camera = camera;
    look(view);
    emit pasted();
    return true;
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "tools/kinds/mask_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/live_stroke.h"
#include "tools/kinds/sketch_hints.h"

namespace vs::desktop {

MaskTool::MaskTool(StudioController& studio) : SketchTool(studio) {}

MaskTool::State MaskTool::state() const {
    return isSketching()     ? State::Sketching
           : isCutting_      ? State::Cutting
           : pad().isEmpty() ? State::Empty
                             : State::Ready;
}

QString MaskTool::hint() const { return withTarget(doing()); }

QString MaskTool::doing() const {
    switch (state()) {
    case State::Empty:
        return drawHint(words().draw);
    case State::Sketching:
        return sketchHint(pad(), SketchEnd::Mask);
    case State::Ready:
        return words().follow;
    case State::Cutting:
        break;
    }
    return words().cut;
}

Overlays MaskTool::overlays() const {
    switch (state()) {
    case State::Empty:
        return {};
    case State::Sketching:
        return sketchOverlays(pad(), idleTint());
    case State::Ready:
        return {{mask(), idleTint(), Overlay::kMaskFill}};
    case State::Cutting:
        break;
    }
    return {{mask(), cuttingTint(), Overlay::kMaskFill}};
}

void MaskTool::press(const Pen& pen) {
    if (picksValue(pen)) {
        return;
    }
    if (state() == State::Ready && isForMask(pen)) {
        beginStroke(pen);
    } else {
        SketchTool::press(pen);
    }
}

void MaskTool::move(const Pen& pen) {
    if (isCutting_) {
        lead(pen);
    } else {
        SketchTool::move(pen);
    }
}

void MaskTool::release(const Pen& pen) {
    if (!isCutting_) {
        SketchTool::release(pen);
        return;
    }
    const bool isOfUse = finish(pen);
    if (isCutting_) { // finish() may have failed
        endStroke(isOfUse);
    }
}

void MaskTool::clear() {
    if (isCutting_) {
        endStroke(false);
    } else {
        SketchTool::clear();
    }
}

// A mask lies elsewhere on another view: it goes, with the stroke in hand.
void MaskTool::viewResized() {
    if (isCutting_) {
        endStroke(false);
    }
    SketchTool::clear();
}

void MaskTool::beginStroke(const Pen& pen) {
    const studio::Sketch mask = sketch();
    if (!studio_.editor().prepareMaterial()) {
        return;
    }
    isCutting_ = studio_.editor().beginStroke([&](auto& document, const auto& canvas) {
        document.stroke().begin(studio_.editor().aimed(stroke(mask, canvas)));
    });
    if (isCutting_) {
        begin(pen);
        emit overlayChanged();
    }
}

bool MaskTool::update(const std::function<void(studio::Document&)>& work) {
    const bool isDone = studio_.host().workLong([&] { work(*studio_.host().document()); });
    if (!isDone) {
        endStroke(false);
    }
    return isDone;
}

void MaskTool::endStroke(bool keep) {
    studio_.editor().endStroke(keep);
    isCutting_ = false;
    emit overlayChanged();
}

} // namespace vs::desktop

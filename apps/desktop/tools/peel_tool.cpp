// SPDX-License-Identifier: Apache-2.0
#include "tools/peel_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/live_stroke.h"
#include "tools/sketch_hints.h"

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr double kLayersPerPixel = 0.1; // thesis, section 4.4: 10 pixels are one layer
}

PeelTool::PeelTool(StudioController& studio) : CutTool(studio) {}

QString PeelTool::hint() const { return withTarget(doing()); }

QString PeelTool::doing() const {
    switch (state_) {
    case State::Empty:
        return drawHint(tr("Draw an outline around the region to peel."));
    case State::Sketching:
        return sketchHint(pad_, SketchEnd::Mask);
    case State::Ready:
        return restores()
                   ? tr("Press inside the mask and drag down to put layers back on. Draw outside it for a "
                        "new "
                        "mask. Esc clears it.")
                   : tr("Press inside the mask and drag down to peel. Draw outside it for a new mask. Esc "
                        "clears it.");
    case State::Peeling:
        break;
    }
    const QString text = restores()
                             ? tr("Down puts back, up takes off: %1 layers. Let go to keep, Esc to undo.")
                             : tr("Down peels, up puts back: %1 layers. Let go to keep, Esc to undo.");
    return text.arg(wanted_, 0, 'f', 1);
}

Overlays PeelTool::overlays() const {
    switch (state_) {
    case State::Empty:
        return {};
    case State::Sketching:
        return sketchOverlays(pad_, idleTint());
    case State::Ready:
        return {{pad_.area(), idleTint(), Overlay::kMaskFill}};
    case State::Peeling:
        break;
    }
    return {{pad_.area(), cuttingTint(), Overlay::kMaskFill}};
}

Qt::CursorShape PeelTool::cursor() const {
    return state_ == State::Peeling || (state_ == State::Ready && isInside_) ? Qt::SizeVerCursor
                                                                             : Qt::CrossCursor;
}

void PeelTool::setState(State state) {
    state_ = state;
    emit overlayChanged();
}

void PeelTool::press(const Pen& pen) {
    if (state_ == State::Ready && pad_.area().contains(pen.position)) {
        pressed_ = pen.position;
        wanted_ = applied_ = 0;
        const auto mask = pad_.sketch(studio_.view().devicePerLogical());
        if (studio_.editor().beginStroke([&](auto& document, const auto& canvas) {
                document.stroke().begin(studio::Peel{mask, 0, radius(), restores(), canvas});
            })) {
            setState(State::Peeling);
        }
        return;
    }
    if (state_ != State::Sketching) { // else the next corner of a polyline
        pad_.begin(studio_.hand().shape(), pen.position, studio_.hand().stencil());
    }
    pad_.press(pen);
    setState(State::Sketching);
}

void PeelTool::move(const Pen& pen) {
    if (state_ == State::Sketching) {
        pad_.extend(pen.position);
        emit overlayChanged();
    } else if (state_ == State::Peeling) {
        peelTo(pen);
    }
}

void PeelTool::peelTo(const Pen& pen) {
    wanted_ = std::max(0.0, kLayersPerPixel * (pen.position.y() - pressed_.y()));
    studio_.host().wake();
    emit layersChanged();
    emit overlayChanged();
}

void PeelTool::release(const Pen& pen) {
    if (state_ == State::Sketching) {
        if (pad_.end(pen.position)) {
            takeMask();
        }
        hover(pen);
    } else if (state_ == State::Peeling) {
        peelTo(pen);
        advance();
        if (state_ == State::Peeling) { // advance() may have failed
            studio_.editor().endStroke(applied_ > 0);
            setState(State::Ready);
        }
    }
}

void PeelTool::takeMask() {
    if (pad_.isOfUse()) {
        isInside_ = false; // until the pen says where it is
        setState(State::Ready);
    } else {
        stop();
    }
}

bool PeelTool::accept() {
    const bool isDone = state_ == State::Sketching && pad_.finish();
    if (isDone) {
        takeMask();
    }
    return isDone;
}

void PeelTool::hover(const Pen& pen) {
    if (state_ == State::Sketching) {
        pad_.extend(pen.position);
        emit overlayChanged();
        return;
    }
    const bool isInside = state_ == State::Ready && pad_.area().contains(pen.position);
    if (isInside != isInside_) {
        isInside_ = isInside;
        emit overlayChanged();
    }
}

void PeelTool::clear() {
    if (state_ == State::Peeling) {
        studio_.editor().endStroke(false);
        wanted_ = applied_ = 0;
        setState(State::Ready);
        emit layersChanged();
    } else {
        stop();
    }
}

void PeelTool::viewResized() {
    if (state_ == State::Peeling) {
        studio_.editor().endStroke(false);
    }
    stop();
}

void PeelTool::stop() {
    pad_.clear();
    setState(State::Empty);
}

void PeelTool::advance() {
    if (state_ != State::Peeling || wanted_ == applied_) {
        return;
    }
    if (studio_.host().workLong([&] { studio_.host().document()->stroke().peelTo(wanted_); })) {
        applied_ = wanted_;
    } else {
        studio_.editor().endStroke(false);
        setState(State::Ready);
    }
}

} // namespace vs::desktop

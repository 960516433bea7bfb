// SPDX-License-Identifier: Apache-2.0
#include "growth_controller.h"

#include "studio_controller.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kSliceMs = 10;
} // namespace

GrowthController::GrowthController(StudioController& studio) : QObject(&studio), studio_(studio) {}

studio::Document::GrowthStatus GrowthController::status() const {
    return studio_.document() != nullptr ? studio_.document()->growth() : studio::Document::GrowthStatus{};
}

bool GrowthController::canPlay() const { return studio_.document() != nullptr && status().hasSeeds; }

void GrowthController::addSeeds(const studio::Seed& seed) {
    if (!studio_.apply(seed)) {
        return;
    }
    if (isAutoStart_ && status().hasSeeds) {
        showRegion();
        play();
    }
    emit changed();
}

void GrowthController::showRegion() {
    // Once: later the person's own choice of mode stands.
    if (hasShownRegion_) {
        return;
    }
    hasShownRegion_ = true;
    auto view = studio_.view();
    if (view.mode == render::Mode::Surface) {
        view.mode = render::Mode::Segment;
    } else if (view.mode == render::Mode::Mip || view.mode == render::Mode::XRay) {
        view.mode = render::Mode::Overlay;
    }
    studio_.look(view);
}

void GrowthController::play() { run(false); }
void GrowthController::toEnd() { run(true); }

void GrowthController::run(bool toEnd) {
    if (!canPlay() || studio_.document()->isStrokeOpen()) {
        return;
    }
    if (!isPlaying_) {
        studio_.canvas(); // the view as it is now is part of the log before the run
        if (!studio_.guard([&] { studio_.document()->beginGrowth(); })) {
            return;
        }
        isPlaying_ = true;
    }
    isToEnd_ = toEnd;
    isWaiting_ = false;
    sincePlay_ = Timer();
    played_ = 0;
    studio_.say(toEnd ? tr("Growing to the end") : tr("Growing"));
    studio_.wake();
    emit changed();
}

bool GrowthController::advance() {
    if (!isPlaying_) {
        return false;
    }
    int most = 1 << 20;
    if (!isToEnd_ && speed_ > 0) {
        const double due = std::floor(sincePlay_.milliseconds() * 1e-3 * speed_);
        most = int(std::min(due - played_, 1000.0));
        isWaiting_ = most < 1;
        if (isWaiting_) {
            return false;
        }
        played_ = due;
    }
    bool goesOn = false;
    const bool done = studio_.guard([&] { goesOn = studio_.document()->growFor(kSliceMs, most); });
    if (!done || !goesOn) {
        finish();
    }
    emit changed();
    return true;
}

void GrowthController::finish() {
    isPlaying_ = false;
    isWaiting_ = false;
    studio_.guard([&] { studio_.report(studio_.document()->endGrowth()); });
}

void GrowthController::pause() {
    if (isPlaying_) {
        studio_.host().makeCurrent();
        finish();
        studio_.wake();
        emit changed();
    }
}

void GrowthController::step() {
    if (canPlay()) {
        showRegion();
        studio_.apply(studio::Grow{1});
        emit changed();
    }
}

void GrowthController::stepBack() {
    if (canPlay()) {
        pause();
        if (status().generation > 1) {
            // Held down, the button goes faster the more there is to take back, and leaves one undo step.
            const bool isHeld = sinceBack_.milliseconds() < 250;
            studio_.rewind(isHeld ? 1 + status().generation / 60 : 1);
            sinceBack_ = Timer();
        }
        emit changed();
    }
}

void GrowthController::setRange(Range range) {
    if (canPlay() && !(status().range == range)) {
        const bool wasPlaying = isPlaying_;
        const bool wasToEnd = isToEnd_;
        studio_.apply(studio::SetGrowthRules{range});
        if (wasPlaying) {
            run(wasToEnd);
        }
        emit changed();
    }
}

void GrowthController::setAutoStart(bool on) {
    isAutoStart_ = on;
    emit changed();
}

void GrowthController::setSpeed(int generationsPerSecond) {
    speed_ = generationsPerSecond;
    sincePlay_ = Timer();
    played_ = 0;
    studio_.wake();
    emit changed();
}

} // namespace vs::desktop

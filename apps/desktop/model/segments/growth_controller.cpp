// SPDX-License-Identifier: Apache-2.0
#include "model/segments/growth_controller.h"

#include "base/error.h"
#include "model/document/document_host.h"
#include "model/document/view_model.h"
#include "model/edits/editor.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_growth.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace vs::desktop {

namespace {
constexpr double kPortionMs = 10;
constexpr double kHurriedPortionMs = 3;
constexpr int kMostAtOnce = 1000;  // generations, when the clock says that so many are due
constexpr double kBackSeconds = 4; // for all of it, played backward at full speed
constexpr double kLeastBack = 30;  // generations per second
constexpr double kAbsorbing = 20;  // likewise at full speed: slow enough to be paused in time
} // namespace

GrowthController::GrowthController(DocumentHost& host, ViewModel& view, Editor& editor)
    : host_(host), view_(view), editor_(editor) {
    constexpr int kCalmMs = 400;
    rulesCalm_.setSingleShot(true);
    rulesCalm_.setInterval(kCalmMs);
    connect(&editor_, &Editor::interrupting, this, &GrowthController::pause);
    connect(&host_, &DocumentHost::opened, this, &GrowthController::reset);
    connect(&host_, &DocumentHost::closing, this, &GrowthController::reset);
    connect(&rulesCalm_, &QTimer::timeout, this, &GrowthController::releaseRules);
    connect(&host_, &DocumentHost::changed, this, [this] {
        if (!takesDisplayedRange_ && !host_.isAway() && host_.document() != nullptr) {
            heldRange_ = range();
        }
    });
}

studio::GrowthStatus GrowthController::status() const { return host_.facts()->growth; }

bool GrowthController::canPlay() const { return status().hasSeeds; }

bool GrowthController::isBusy() const {
    return isPlaying() || scrubbed_.has_value() || rules_.has_value() || host_.facts()->isScrubbing();
}

void GrowthController::reset() {
    hasShownRegion_ = false;
    takesDisplayedRange_ = true;
    heldRange_ = {};
    hasRunOut_ = false;
    limit_.letGo();
}

Range GrowthController::range() const {
    const Range own = host_.facts()->rules.range;
    const Range otherwise = takesDisplayedRange_ || heldRange_ == Range() ? view_.visibleRange() : heldRange_;
    return own == Range() ? otherwise : own;
}

void GrowthController::showRegion() {
    if (hasShownRegion_) {
        return;
    }
    hasShownRegion_ = true;
    auto view = view_.shown();
    if (view.mode == render::Mode::Surface) {
        view.mode = render::Mode::Segment;
    } else if (view.mode == render::Mode::Mip || view.mode == render::Mode::XRay) {
        view.mode = render::Mode::Overlay;
    }
    view_.showView(view);
}

void GrowthController::prepare() {
    if (host_.isAway() || host_.isLoading() || host_.document() == nullptr) {
        return;
    }
    try {
        host_.runLong([&] { host_.document()->growing().prepare(); });
    } catch (const Error&) { // no room: the stroke says so, if there is none then
        giveBack();
    } catch (const std::bad_alloc&) {
        giveBack();
    }
}

void GrowthController::giveBack() {
    if (!host_.isAway() && host_.document() != nullptr) {
        host_.gl().makeCurrent();
        host_.document()->growing().giveBack();
    }
}

// --- strokes

void GrowthController::addSeeds(const studio::Seed& seed) {
    pause();
    studio::Seed stroke = seed;
    const auto rules = host_.facts()->rules;
    stroke.connectivity = rules.connectivity;
    if (!takesDisplayedRange_) {
        stroke.range = range();
    }
    const bool isFirst = status().voxels == 0;
    if (!editor_.apply(stroke)) {
        return;
    }
    if (isFirst) {
        limitFirstStroke();
    }
    if (isAutoStart_ && status().hasSeeds) {
        showRegion();
        start(Run::Forward);
    }
    emit changed();
}

void GrowthController::absorb(const studio::Absorb& stroke) {
    studio::Absorb first = stroke;
    first.expansions = 1;
    if (editor_.apply(first) && isAutoStart_ && lastAbsorbed() != nullptr) {
        start(Run::Absorbing);
    }
    emit changed();
}

// The stroke that absorbing goes on with.
const studio::Absorb* GrowthController::lastAbsorbed() const {
    const auto* last = host_.facts()->lastEdit();
    return last != nullptr && strokesAbsorb_ ? std::get_if<studio::Absorb>(last) : nullptr;
}

// --- playback

void GrowthController::play() { start(lastAbsorbed() != nullptr ? Run::Absorbing : Run::Forward); }
void GrowthController::toEnd() { start(Run::ToEnd); }
void GrowthController::playBackward() { start(Run::Backward); }

void GrowthController::start(Run run) {
    if (!canPlay() || host_.facts()->isStrokeOpen()) {
        return;
    }
    const bool goesOn = (run_ == Run::Forward || run_ == Run::ToEnd) &&
                        (run == Run::Forward || run == Run::ToEnd); // only the pace changes
    if (!goesOn) {
        pause();
        view_.flush(); // the view as it is now is part of the log before the run
        if ((run == Run::Forward || run == Run::ToEnd) &&
            !host_.workLong([&] { host_.document()->growing().begin(); })) {
            return;
        }
    }
    run_ = run;
    isWaiting_ = false;
    isJustBegun_ = true;
    hasRunOut_ = false;
    sinceStart_ = Timer();
    played_ = 0;
    if (run == Run::ToEnd) {
        limit_.letGo();
    }
    host_.say(run == Run::Backward    ? tr("Playing backward")
              : run == Run::Absorbing ? tr("Absorbing")
              : run == Run::ToEnd     ? tr("Growing to the end")
                                      : tr("Growing"));
    host_.wake();
    emit changed();
}

// How many generations the clock wants now; none: it is waited for.
int GrowthController::due() {
    double perSecond = speed_;
    if (speed_ == 0 && run_ == Run::Backward) {
        perSecond = std::max(kLeastBack, status().extent / kBackSeconds);
    } else if (speed_ == 0 && run_ == Run::Absorbing) {
        perSecond = kAbsorbing;
    } else if (speed_ == 0 || run_ == Run::ToEnd) {
        return 1 << 20;
    }
    const double now = std::floor(sinceStart_.milliseconds() * 1e-3 * perSecond);
    const int steps = int(std::min<double>(now - played_, kMostAtOnce));
    isWaiting_ = steps < 1;
    played_ = isWaiting_ ? played_ : now;
    return std::max(steps, 0);
}

bool GrowthController::advance() {
    if (rules_ && rules_->isStale) {
        applyRules();
        return true;
    }
    if (scrubbed_) {
        showScrubbed();
        return true;
    }
    switch (run_) {
    case Run::None:
        return false;
    case Run::Backward:
        return goBack();
    case Run::Absorbing:
        if (const int steps = due(); steps > 0) {
            if (!absorbFurther(steps)) {
                finish();
            }
            emit changed();
            return true;
        }
        return false;
    case Run::Forward:
    case Run::ToEnd:
        break;
    }
    return growOn();
}

bool GrowthController::growOn() {
    const int steps = due();
    if (steps == 0) {
        return false;
    }
    // The first is soon seen: it is the answer to a stroke.
    const bool isFirst = std::exchange(isJustBegun_, false);
    const double portionMs = host_.isHandAtWork() || isFirst ? kHurriedPortionMs : kPortionMs;
    bool goesOn = false;
    const bool done =
        host_.workLong([&] { goesOn = host_.document()->growing().growFor(portionMs, steps, mostVoxels()); });
    const bool isLimitReached = done && goesOn && status().voxels >= mostVoxels();
    if (!done || !goesOn || isLimitReached) {
        finish();
        hasRunOut_ = done && !goesOn;
    }
    if (isLimitReached) {
        limit_.stop(*host_.facts());
        sayLimit();
    }
    emit changed();
    return true;
}

bool GrowthController::goBack() {
    const int steps = due();
    if (steps == 0) {
        return false;
    }
    const int generation = std::max(1, status().generation - steps);
    if (!host_.workLong([&] { host_.document()->growing().scrub(generation); }) || generation == 1) {
        finish();
    }
    emit changed();
    return true;
}

// False: nothing is left, or it failed.
bool GrowthController::absorbFurther(int expansions) {
    const studio::Absorb* last = lastAbsorbed();
    if (last == nullptr || !last->expansions) {
        return false;
    }
    studio::Absorb further = *last;
    *further.expansions += expansions;
    const std::size_t before = status().voxels;
    const bool done =
        editor_.perform([&] { return host_.document()->replaceLast(studio::Operation(further)); });
    return done && status().voxels < before;
}

void GrowthController::finish() {
    const Run run = std::exchange(run_, Run::None);
    isWaiting_ = false;
    if (run == Run::Forward || run == Run::ToEnd) {
        editor_.perform([&] { return host_.document()->growing().end(); });
    } else if (run == Run::Backward && host_.facts()->isScrubbing()) {
        editor_.perform([&] { return host_.document()->growing().endScrub(); });
    }
}

void GrowthController::pause() {
    hasRunOut_ = false; // something else is about to be done
    if (rules_) {
        finishRules(false);
    }
    if (scrubbed_ || (run_ == Run::None && host_.facts()->isScrubbing())) {
        endScrub();
    }
    if (isPlaying()) {
        host_.gl().makeCurrent();
        finish();
        host_.wake();
        emit changed();
    }
}

void GrowthController::stop() {
    pause();
    limit_.forget();
    host_.say(tr("Stopped"));
    emit changed();
}

void GrowthController::whilePaused(const std::function<void()>& edit) {
    const Run before = run_;
    edit();
    if (before == Run::Forward || before == Run::ToEnd) {
        start(before);
    }
}

void GrowthController::step() {
    if (!canPlay()) {
        return;
    }
    pause();
    showRegion();
    if (lastAbsorbed() != nullptr) {
        absorbFurther(1);
        host_.wake();
    } else {
        editor_.apply(studio::Grow{1});
    }
    emit changed();
}

void GrowthController::takeBack() {
    if (canPlay()) {
        pause();
        if (status().generation > 1) {
            // Held down, the button goes faster the more there is to take back, and leaves one undo step.
            const bool isHeld = sinceBack_.milliseconds() < 250;
            editor_.rewind(isHeld ? 1 + status().generation / 60 : 1);
            sinceBack_ = Timer();
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
    sinceStart_ = Timer();
    played_ = 0;
    host_.wake();
    emit changed();
}

} // namespace vs::desktop

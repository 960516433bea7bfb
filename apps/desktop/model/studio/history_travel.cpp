// SPDX-License-Identifier: Apache-2.0
#include "model/studio/history_travel.h"

#include "model/studio/studio_controller.h"

#include "base/timer.h"

#include <cstdlib>

namespace vs::desktop {

namespace {
constexpr double kSliceMs = 40;
} // namespace

HistoryTravel::HistoryTravel(StudioController& studio) : studio_(studio) {
    connect(&timer_, &QTimer::timeout, this, &HistoryTravel::advance);
    connect(&studio, &StudioController::closed, this, &HistoryTravel::stop);
    connect(&studio, &StudioController::givenUp, this, &HistoryTravel::stop);
}

void HistoryTravel::goTo(std::size_t steps) {
    auto* document = studio_.document();
    if (document == nullptr || studio_.isLoading() || steps > document->steps().operations.size()) {
        return;
    }
    from_ = at_ = document->steps().done;
    target_ = steps;
    timer_.start(0);
    advance(); // a short way at once
}

void HistoryTravel::advance() {
    const Timer timer;
    while (target_ && timer.milliseconds() < kSliceMs) {
        if (studio_.document() == nullptr || studio_.document()->steps().done != at_ || at_ == *target_ ||
            !takeOne()) {
            stop();
        }
    }
    if (target_) {
        const auto way = [](std::size_t a, std::size_t b) { return std::abs(int(a) - int(b)); };
        emit studio_.progress(way(at_, from_), way(*target_, from_));
    }
}

bool HistoryTravel::takeOne() {
    const bool isDone = at_ > *target_ ? studio_.apply(studio::Undo{}) : studio_.apply(studio::Redo{});
    at_ = isDone ? studio_.document()->steps().done : at_;
    return isDone;
}

void HistoryTravel::stop() {
    if (target_) {
        target_.reset();
        timer_.stop();
        emit studio_.progress(1, 1);
    }
}

} // namespace vs::desktop

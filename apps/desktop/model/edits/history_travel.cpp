// SPDX-License-Identifier: Apache-2.0
#include "model/edits/history_travel.h"

#include "model/document/document_host.h"
#include "model/edits/editor.h"

#include "base/timer.h"
#include "studio/document/document_facts.h"

#include <cstdlib>

namespace vs::desktop {

namespace {
constexpr double kPortionMs = 40;
} // namespace

HistoryTravel::HistoryTravel(DocumentHost& host, Editor& editor) : host_(host), editor_(editor) {
    connect(&timer_, &QTimer::timeout, this, &HistoryTravel::advance);
    connect(&host_, &DocumentHost::closed, this, &HistoryTravel::stop);
    connect(&host_, &DocumentHost::givenUp, this, &HistoryTravel::stop);
}

void HistoryTravel::goTo(std::size_t steps) {
    auto* document = host_.document();
    if (document == nullptr || host_.isLoading() || steps > host_.facts()->edits->operations.size()) {
        return;
    }
    from_ = at_ = host_.facts()->edits->done;
    target_ = steps;
    timer_.start(0);
    advance(); // a short way at once
}

void HistoryTravel::advance() {
    const Timer timer;
    while (target_ && timer.milliseconds() < kPortionMs) {
        if (host_.document() == nullptr || host_.facts()->edits->done != at_ || at_ == *target_ ||
            !takeOne()) {
            stop();
        }
    }
    if (target_) {
        const auto way = [](std::size_t a, std::size_t b) { return std::abs(int(a) - int(b)); };
        emit host_.progress(way(at_, from_), way(*target_, from_));
    }
}

bool HistoryTravel::takeOne() {
    const bool isDone = at_ > *target_ ? editor_.apply(studio::Undo{}) : editor_.apply(studio::Redo{});
    at_ = isDone ? host_.facts()->edits->done : at_;
    return isDone;
}

void HistoryTravel::stop() {
    if (target_) {
        target_.reset();
        timer_.stop();
        emit host_.progress(1, 1);
    }
}

} // namespace vs::desktop

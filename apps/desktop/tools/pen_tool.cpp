// SPDX-License-Identifier: Apache-2.0
#include "tools/pen_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/live_stroke.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
// Press and hold: from a light touch to full pressure.
constexpr double kRampFrom = 0.2;
constexpr double kRampMs = 1000;
constexpr double kRampStep = 0.05; // of pressure: less would not be seen
} // namespace

PenTool::PenTool(StudioController& studio, Depths depths)
    : MaskTool(studio), depths_(depths), depth_(depths.usual) {}

void PenTool::setDepth(double steps) {
    depth_ = steps;
    tell();
}

void PenTool::setKeepsDigging(bool on) {
    keepsDigging_ = on;
    tell();
}

QPainterPath PenTool::mask() const {
    QPainterPath path = pad().area();
    if (isPenOver_) {
        path.translate(pen_ - pad().centre());
    }
    return path;
}

void PenTool::press(const Pen& pen) {
    pen_ = pen.position;
    isPenOver_ = true;
    MaskTool::press(pen);
}

studio::Operation PenTool::stroke(const studio::Sketch& mask, const studio::Canvas& canvas) const {
    studio::PenCut cut;
    cut.mask = mask;
    cut.depthMax = strokeDepth();
    cut.radius = radius();
    cut.restores = restores();
    cut.keepsDigging = keepsDigging_;
    cut.canvas = canvas;
    return operation(cut);
}

void PenTool::begin(const Pen& pen) {
    waiting_.clear();
    hasBegun_ = false;
    last_ = {glm::dvec2(-1e9), 0};
    sincePress_ = Timer();
    ramping_.reset();
    if (pen.isMouse && studio_.hand().rampsPressure()) {
        ramping_ = pen;
    }
    lead(pen);
}

void PenTool::move(const Pen& pen) {
    pen_ = pen.position;
    MaskTool::move(pen);
    emit overlayChanged();
}

bool PenTool::finish(const Pen&) {
    ramping_.reset();
    cut(1e9); // all that is waiting
    if (state() == State::Cutting) {
        studio_.host().document()->stroke().setByHand();
    }
    return true;
}

void PenTool::takeSketch() {
    isPenOver_ = false; // stays where it was drawn until the pen moves
}

void PenTool::hover(const Pen& pen) {
    isPenOver_ = true;
    pen_ = pen.position;
    if (isSketching()) {
        MaskTool::hover(pen);
    } else if (state() != State::Empty) {
        emit overlayChanged();
    }
}

void PenTool::leave() {
    isPenOver_ = false;
    if (state() == State::Ready) {
        emit overlayChanged();
    }
}

double PenTool::pressureOf(const Pen& pen) const {
    return ramping_ ? std::min(kRampFrom + (1 - kRampFrom) * sincePress_.milliseconds() / kRampMs, 1.0)
                    : pen.pressure;
}

void PenTool::lead(const Pen& pen) {
    if (ramping_) {
        ramping_ = pen;
    }
    const sculpt::PenPoint point{glm::dvec2(pen.position.x(), pen.position.y()) *
                                     studio_.view().devicePerLogical(),
                                 pressureOf(pen), glm::dvec2(pen.tiltDegrees.x(), pen.tiltDegrees.y())};
    // Energy counts once per place, so a report from the same place that presses no harder would change
    // nothing.
    if (glm::distance(point.pixel, last_.pixel) < 1 && point.pressure <= last_.pressure) {
        return;
    }
    last_ = point;
    waiting_.push_back(point);
    studio_.host().wake();
}

void PenTool::advance() {
    constexpr double kPortionMs = 18; // less, and a hasty pen would be followed ever later
    ramp();
    cut(kPortionMs);
}

// A mouse that is held still presses harder too.
void PenTool::ramp() {
    if (state() != State::Cutting || !ramping_ || last_.pressure >= 1) {
        return;
    }
    const double pressure = pressureOf(*ramping_);
    if (waiting_.empty() && (pressure >= last_.pressure + kRampStep || pressure >= 1)) {
        lead(*ramping_);
    }
    studio_.host().wake(); // until it is full
}

// A point costs as much as a whole stretch. Where the pen has gone on straight, the last of those that wait
// says as much as all of them.
void PenTool::straighten() {
    const auto begin = waiting_.begin();
    std::ptrdiff_t dropped = 0;
    while (dropped + 1 < std::ptrdiff_t(waiting_.size()) &&
           std::all_of(begin, begin + dropped + 1, [&](const auto& point) {
               return sculpt::isOnWay(point, done_, begin[dropped + 1]);
           })) {
        ++dropped;
    }
    waiting_.erase(begin, begin + dropped);
}

void PenTool::cut(double budgetMs) {
    const Timer timer;
    while (state() == State::Cutting && !waiting_.empty()) {
        if (hasBegun_ && !keepsDigging_) {
            straighten();
        }
        done_ = waiting_.front();
        waiting_.pop_front();
        hasBegun_ = true;
        if (!update([&](studio::Document& document) { document.stroke().drawAt(done_); })) {
            return;
        }
        if (timer.milliseconds() > budgetMs) {
            studio_.host().wake();
            return;
        }
    }
}

} // namespace vs::desktop

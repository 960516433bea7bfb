// SPDX-License-Identifier: Apache-2.0
#include "drill_tool.h"

#include "studio_controller.h"

#include "base/timer.h"

#include <cmath>

namespace vs::desktop {

DrillTool::DrillTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

QString DrillTool::hint() const {
    switch (state_) {
    case State::Empty:
        return tr("Draw the shape of the drill anywhere; it closes when you let go.");
    case State::Sketching:
        return tr("Let go to close the mask. Esc drops it.");
    case State::Ready:
        return tr("The mask follows the pen. Press and move to drill. Esc clears it for a new shape.");
    case State::Drilling:
        break;
    }
    return tr("Drilling: press harder to go deeper. Let go to keep, Esc to undo.");
}

Overlay DrillTool::overlay() const {
    if (state_ == State::Empty) {
        return {};
    }
    if (state_ == State::Sketching) {
        return {pad_.outline(), Overlay::Tint::Pen, false, 2};
    }
    QPainterPath path = pad_.area();
    if (isPenOver_) {
        path.translate(pen_ - pad_.centre());
    }
    return {path, state_ == State::Drilling ? Overlay::Tint::Cutting : Overlay::Tint::Idle, true, 2};
}

void DrillTool::setState(State state) {
    state_ = state;
    emit overlayChanged();
}

void DrillTool::press(const Pen& pen) {
    pen_ = pen.position;
    isPenOver_ = true;
    if (state_ != State::Ready) {
        pad_.begin(studio_.shape(), pen.position);
        setState(State::Sketching);
        return;
    }
    const auto mask = pad_.sketch(studio_.devicePerLogical());
    const bool begun = studio_.beginStroke([&](auto& document, const auto& canvas) {
        studio::Drill drill;
        drill.mask = mask;
        drill.canvas = canvas;
        drill.depthMax = depth_;
        document.beginStroke(drill);
    });
    if (begun) {
        waiting_.clear();
        last_ = {glm::dvec2(-1e9), 0};
        setState(State::Drilling);
        enqueue(pen);
    }
}

void DrillTool::move(const Pen& pen) {
    pen_ = pen.position;
    if (state_ == State::Sketching) {
        pad_.extend(pen.position);
    } else if (state_ == State::Drilling) {
        enqueue(pen);
    }
    emit overlayChanged();
}

void DrillTool::release(const Pen& pen) {
    if (state_ == State::Sketching) {
        pad_.extend(pen.position);
        isPenOver_ = false; // stays where it was drawn until the pen moves
        if (pad_.hasArea()) {
            setState(State::Ready);
        } else {
            abandon();
        }
    } else if (state_ == State::Drilling) {
        drill(1e9);                      // all that is waiting
        if (state_ == State::Drilling) { // drill() may have failed
            studio_.endStroke(true);
            setState(State::Ready);
        }
    }
}

void DrillTool::hover(const Pen& pen) {
    pen_ = pen.position;
    isPenOver_ = true;
    if (state_ == State::Ready) {
        emit overlayChanged();
    }
}

void DrillTool::leave() {
    isPenOver_ = false;
    if (state_ == State::Ready) {
        emit overlayChanged();
    }
}

void DrillTool::clear() {
    if (state_ == State::Drilling) {
        waiting_.clear();
        studio_.endStroke(false);
        setState(State::Ready);
    } else {
        abandon();
    }
}

void DrillTool::viewResized() {
    if (state_ == State::Drilling) {
        studio_.endStroke(false);
    }
    abandon();
}

void DrillTool::abandon() {
    pad_.clear();
    waiting_.clear();
    setState(State::Empty);
}

void DrillTool::enqueue(const Pen& pen) {
    const sculpt::PenPoint point{glm::dvec2(pen.position.x(), pen.position.y()) * studio_.devicePerLogical(),
                                 pen.pressure};
    // Energy counts once per place, so a report from the same place that presses no harder would change
    // nothing.
    if (glm::distance(point.pixel, last_.pixel) < 1 && point.pressure <= last_.pressure) {
        return;
    }
    last_ = point;
    waiting_.push_back(point);
    studio_.wake();
}

void DrillTool::advance() {
    constexpr double kSliceMs = 10;
    drill(kSliceMs);
}

void DrillTool::drill(double budgetMs) {
    const Timer timer;
    while (state_ == State::Drilling && !waiting_.empty()) {
        const auto point = waiting_.front();
        waiting_.pop_front();
        if (!studio_.guard([&] { studio_.document()->updatePen(point); })) {
            waiting_.clear();
            studio_.endStroke(false);
            setState(State::Ready);
            return;
        }
        if (timer.milliseconds() > budgetMs) {
            studio_.wake();
            return;
        }
    }
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "tools/playing/drawn_acts.h"

#include "model/studio/studio_controller.h"
#include "render/camera/viewport_fit.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_stroke.h"

#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kPixelsPerSecond = 700; // a pen that does not hurry
constexpr double kLeastSeconds = 0.5;    // of drawing, and of cutting
constexpr double kMostSeconds = 2.5;
constexpr double kPeelLayersPerSecond = 8;

double lengthOf(const studio::Drawn::Line& line, bool isClosed) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += glm::distance(line[i - 1], line[i]);
    }
    return isClosed && line.size() > 1 ? length + glm::distance(line.back(), line.front()) : length;
}

double secondsFor(double length) {
    return std::clamp(length / kPixelsPerSecond, kLeastSeconds, kMostSeconds);
}

// The first part of a line, so many pixels long.
studio::Drawn::Line beginningOf(const studio::Drawn::Line& line, double length) {
    studio::Drawn::Line part;
    for (const glm::dvec2 point : line) {
        if (!part.empty()) {
            const double way = glm::distance(part.back(), point);
            if (way >= length) {
                part.push_back(glm::mix(part.back(), point, way > 0 ? length / way : 0));
                return part;
            }
            length -= way;
        }
        part.push_back(point);
    }
    return part;
}

QPainterPath pathOf(const QPolygonF& line) {
    QPainterPath path;
    path.addPolygon(line);
    return path;
}

// The operation with what it was drawn on, as it is replayed elsewhere: the view at that moment, on a
// viewport of the usual size.
studio::Operation withCanvas(studio::Operation operation, const studio::View& view) {
    const auto set = [&view](auto& op) {
        if constexpr (requires { op.canvas; }) {
            op.canvas = op.canvas.value_or(studio::Canvas{.view = view});
        }
    };
    std::visit(
        [&set](auto& op) {
            set(op);
            if constexpr (std::is_same_v<std::decay_t<decltype(op)>, studio::BrushSegment>) {
                std::visit(set, op.stroke);
            }
        },
        operation);
    return operation;
}

} // namespace

DrawnAct::DrawnAct(studio::Operation operation, StudioController& studio)
    : Act(studio), operation_(withCanvas(std::move(operation), studio.view().shown())),
      drawn_(studio::drawnFor(operation_)), canvas_(drawn_.canvas.value_or(studio::Canvas{})) {
    for (const auto& area : drawn_.areas) {
        length_ += lengthOf(area, true);
    }
    for (const auto& line : drawn_.lines) {
        length_ += lengthOf(line, false);
    }
    seconds_ = secondsFor(length_);
}

Act::State DrawnAct::advance(double seconds) {
    if (seconds < seconds_) {
        shown_ = length_ * seconds / seconds_;
        return State::GoesOn;
    }
    shown_ = length_;
    isAllDrawn_ = true;
    return carryOut(seconds - seconds_);
}

Act::State DrawnAct::carryOut(double) { return DrawnAct::complete(); }

Act::State DrawnAct::complete() { return studio_.editor().apply(operation_) ? State::Done : State::Failed; }

std::optional<QPolygonF> DrawnAct::seen(const studio::Drawn::Line& line) const {
    const auto* geometry = studio_.host().geometry();
    if (geometry == nullptr || !(studio_.view().shown().camera == canvas_.view.camera)) {
        return {};
    }
    const render::ViewportFit fit(canvas_.view.camera, *geometry, canvas_.viewport,
                                  studio_.view().viewport());
    QPolygonF polygon;
    for (const glm::dvec2 point : line) {
        const glm::dvec2 place = fit(point) / studio_.view().devicePerLogical();
        polygon << QPointF(place.x, place.y);
    }
    return polygon;
}

void DrawnAct::addPart(Overlays& overlays, const studio::Drawn::Line& line, double& left,
                       bool isClosed) const {
    studio::Drawn::Line whole = line;
    if (isClosed && !whole.empty()) {
        whole.push_back(whole.front());
    }
    const double length = lengthOf(whole, false);
    const bool isWhole = left >= length;
    if (const auto part = seen(isWhole ? whole : beginningOf(whole, left)); part && left > 0) {
        overlays.push_back({pathOf(*part), isWhole && isClosed ? Overlay::Tint::Idle : Overlay::Tint::Seed,
                            isWhole && isClosed ? Overlay::kMaskFill : 0.0});
    }
    left -= length;
}

Overlays DrawnAct::overlays() const {
    Overlays overlays;
    double left = shown_;
    for (const auto& area : drawn_.areas) {
        addPart(overlays, area, left, true);
    }
    for (const auto& line : drawn_.lines) {
        addPart(overlays, line, left, false);
    }
    return overlays;
}

// --- cuts

Act::State CutAct::begin() {
    studio::Operation first = operation_;
    std::visit(
        [](auto& op) {
            if constexpr (requires { op.layers; }) {
                op.layers = 0;
            } else if constexpr (requires { op.depthMax; }) {
                op.stroke.clear();
            }
        },
        first);
    isOpen_ = studio_.editor().beginStroke(
        [&](studio::Document& document, const studio::Canvas&) { document.stroke().begin(first); });
    return isOpen_ ? State::GoesOn : State::Failed;
}

Act::State CutAct::cutTo(double share) {
    const bool isDone = studio_.host().workLong([&] {
        studio::LiveStroke& stroke = studio_.host().document()->stroke();
        if (const auto* peel = std::get_if<studio::Peel>(&operation_)) {
            stroke.peelTo(share * peel->layers);
            return;
        }
        const sculpt::Stroke& pen = std::visit(
            [](const auto& op) -> const sculpt::Stroke& {
                if constexpr (requires { op.depthMax; }) {
                    return op.stroke;
                } else {
                    static const sculpt::Stroke none;
                    return none;
                }
            },
            operation_);
        for (; places_ < std::size_t(std::ceil(share * double(pen.size()))); ++places_) {
            stroke.drawAt(pen[places_]);
        }
    });
    return isDone ? State::GoesOn : State::Failed;
}

Act::State CutAct::commit() {
    isOpen_ = false;
    return studio_.editor().endStroke(true) ? State::Done : State::Failed;
}

Act::State CutAct::carryOut(double seconds) {
    const auto* peel = std::get_if<studio::Peel>(&operation_);
    if (peel == nullptr && drawn_.way.empty()) { // one stamp
        return DrawnAct::complete();
    }
    if (!isOpen_ && begin() == State::Failed) {
        return State::Failed;
    }
    const double length = peel != nullptr ? peel->layers * kPixelsPerSecond / kPeelLayersPerSecond
                                          : lengthOf(drawn_.way, false);
    const double share = std::min(seconds / secondsFor(length), 1.0);
    if (cutTo(share) == State::Failed) {
        return State::Failed;
    }
    return share < 1 ? State::GoesOn : commit();
}

Act::State CutAct::complete() {
    if (!isOpen_) {
        return DrawnAct::complete();
    }
    return cutTo(1) == State::Failed ? State::Failed : commit();
}

std::optional<studio::Operation> CutAct::stopHere() {
    if (!isOpen_) {
        return operation_;
    }
    complete();
    return {};
}

Overlays CutAct::overlays() const {
    if (!isOpen_ || drawn_.areas.empty()) {
        return DrawnAct::overlays();
    }
    const studio::Drawn::Line& area = drawn_.areas.front();
    const auto place =
        places_ > 0 && places_ <= drawn_.way.size() ? drawn_.areaAt(area, drawn_.way[places_ - 1]) : area;
    const auto outline = seen(place);
    if (!outline) {
        return {};
    }
    QPainterPath path = pathOf(*outline);
    path.closeSubpath();
    return {{path, Overlay::Tint::Cutting, Overlay::kMaskFill}};
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "tools/sweep_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/surface_queries.h"
#include "tools/kinds/sketch_hints.h"
#include "tools/sweep_along_view.h"
#include "tools/sweep_way.h"

namespace vs::desktop {

SweepTool::SweepTool(StudioController& studio) : SketchTool(studio) {
    connect(&studio.host(), &DocumentHost::changed, this, &SweepTool::forgetOldView);
    connect(this, &CutTool::settingsChanged, this, &SweepTool::prepare);
    constexpr int kCalmMs = 150;
    calm_.setSingleShot(true);
    calm_.setInterval(kCalmMs);
    connect(&calm_, &QTimer::timeout, this, &SweepTool::prepare);
}

QString SweepTool::hint() const {
    if (isDrawingMask()) {
        return sketchHint(pad(), SketchEnd::Mask);
    }
    switch (state_) {
    case State::Empty:
        return drawHint(tr("Draw the shape that is to be swept."));
    case State::HasMask:
        return isDrawn() ? wayHint()
                         : tr("Nothing is under the shape, so the way cannot begin there. Esc clears it.");
    case State::DrawingWay:
        return settings_.line != Line::FreeHand
                   ? tr("Click the next corner. Enter or a double click ends the way, Esc drops it.")
               : !settings_.cutsAtPenUp || actsOnMaterial() ? tr("Let go where the way ends. Esc drops it.")
               : restores() ? tr("Let go where the way ends: what it covers is put back. Esc drops it.")
                            : tr("Let go where the way ends: what it covers is cut. Esc drops it.");
    case State::Ready:
        break;
    }
    const QString what = actsOnMaterial()
                             ? (isReversed() ? tr("Enter takes material away from what is shown. ")
                                             : tr("Enter fills what is shown. "))
                         : restores() ? tr("Enter restores what is shown. ")
                                      : tr("Enter cuts what is shown. ");
    return what + (isDrawn() ? tr("Draw again for another way. Esc drops it.")
                             : tr("Draw again for another shape. Esc drops it."));
}

Overlays SweepTool::overlays() const {
    Overlays overlays;
    if (isDrawingMask()) {
        overlays = sketchOverlays(pad(), idleTint());
    } else if (state_ == State::HasMask || state_ == State::DrawingWay) {
        overlays.push_back({pad().area(), idleTint(), Overlay::kMaskFill});
    }
    if (state_ == State::Ready) {
        overlays.push_back({outlines_, idleTint(), 0, 1.5});
    }
    if (state_ == State::DrawingWay || (state_ == State::Ready && isDrawn())) {
        overlays.push_back({drawnWay(), Overlay::Tint::Pen});
    }
    return overlays;
}

QString SweepTool::wayHint() const {
    return settings_.line == Line::FreeHand
               ? tr("Draw the way that the shape goes. Esc clears it for a new shape.")
               : tr("Click the corners of the way that the shape goes. Esc clears it for a new shape.");
}

// In the view's logical pixels, to the pen while corners are set.
QPainterPath SweepTool::drawnWay() const {
    const QPainterPath corners = way_.outline();
    if (settings_.line != Line::Spline) {
        return corners;
    }
    std::vector<glm::dvec2> places;
    for (int n = 0; n < corners.elementCount(); ++n) {
        places.emplace_back(corners.elementAt(n).x, corners.elementAt(n).y);
    }
    QPainterPath way;
    for (const glm::dvec2 place : wayThrough(places, settings_.line)) {
        way.isEmpty() && way.elementCount() == 0 ? way.moveTo(place.x, place.y)
                                                 : way.lineTo(place.x, place.y);
    }
    return way;
}

bool SweepTool::isDrawn() const { return settings_.way == Way::Surface || settings_.way == Way::ViewPlane; }

void SweepTool::setState(State state) {
    state_ = state;
    emit overlayChanged();
}

void SweepTool::set(const Settings& settings) {
    const bool wasDrawn = isDrawn();
    const bool isLineNew = settings.line != settings_.line;
    settings_ = settings;
    if ((wasDrawn != isDrawn() && state_ == State::Ready) ||
        (isLineNew && (state_ == State::Ready || state_ == State::DrawingWay) && isDrawn())) {
        sweep_.reset();
        way_.clear();
        state_ = State::HasMask;
    }
    tell();
}

void SweepTool::press(const Pen& pen) {
    if (picksValue(pen)) {
        return;
    }
    if (state_ != State::Empty && isDrawn()) {
        if (state_ != State::DrawingWay) { // else the next corner
            const bool isByHand = settings_.line == Line::FreeHand;
            way_.begin(isByHand ? studio::Shape::FreeForm : studio::Shape::Polyline, pen.position, {},
                       SketchPad::Needs::Line);
        }
        way_.press(pen);
        setState(State::DrawingWay);
        return;
    }
    if (!isDrawingMask()) {
        abandon();
    }
    SketchTool::press(pen);
}

void SweepTool::move(const Pen& pen) {
    if (state_ == State::DrawingWay) {
        way_.extend(pen.position);
        emit overlayChanged();
    } else {
        SketchTool::move(pen);
    }
}

void SweepTool::release(const Pen& pen) {
    move(pen);
    if (state_ == State::DrawingWay) {
        if (way_.end(pen.position)) {
            takeSketch();
        }
        emit overlayChanged();
    } else {
        SketchTool::release(pen);
    }
}

// The mask, or then a way.
void SweepTool::takeSketch() {
    setState(State::HasMask);
    prepare();
    if (state_ == State::Ready && settings_.cutsAtPenUp) {
        accept();
    }
}

// What would be cut with the present settings, and its preview. Stays without a way until there is one.
void SweepTool::prepare() {
    if (state_ != State::HasMask && state_ != State::Ready) {
        return;
    }
    sweep_ = drawnSweep();
    state_ = State::HasMask;
    if (sweep_) {
        preview();
    }
    emit overlayChanged();
}

std::optional<studio::Sweep> SweepTool::drawnSweep() {
    const glm::dvec2 scale = studio_.view().devicePerLogical();
    const studio::Canvas canvas = studio_.view().canvas();
    studio::Sweep sweep;
    if (isDrawn()) {
        if (way_.isEmpty()) {
            return std::nullopt;
        }
        sweep.mask = sketch();
        sweep.path.kind = settings_.way == Way::Surface ? studio::SweepPath::Kind::Surface
                                                        : studio::SweepPath::Kind::ViewPlane;
        sweep.path.stroke = wayThrough(way_.sketch(scale).points, settings_.line);
    } else {
        const QPointF centre = pad().centre();
        std::optional<studio::Probe> start;
        studio_.host().workLong([&] {
            start = studio_.host().document()->surface().probe(glm::dvec2(centre.x(), centre.y()) * scale,
                                                               canvas.viewport);
        });
        if (!start) {
            return std::nullopt;
        }
        sweep = sweepAlongView(sketch(), *start, settings_, canvas, *studio_.host().geometry());
    }
    sweep.frame = settings_.frame;
    sweep.isRaw = settings_.isRaw;
    sweep.filter = settings_.filter;
    sweep.radius = radius();
    sweep.restores = restores();
    sweep.canvas = canvas;
    return sweep;
}

void SweepTool::preview() {
    outlines_ = {};
    std::vector<std::vector<glm::dvec2>> outlines;
    studio_.host().workLong(
        [&] { outlines = studio_.host().document()->surface().outlinesAlongPath(*sweep_); });
    for (const auto& outline : outlines) {
        outlines_.addPath(closedPath(outline, studio_.view().devicePerLogical()));
    }
    if (outlines_.isEmpty()) {
        sweep_.reset();
        studio_.host().say(tr("The way leads nowhere: draw it on the object, or longer"));
    } else {
        state_ = State::Ready;
    }
}

bool SweepTool::accept() {
    if (isDrawingMask()) {
        return SketchTool::accept();
    }
    if (state_ == State::DrawingWay && way_.finish()) {
        takeSketch();
        return true;
    }
    if (state_ != State::Ready) {
        return false;
    }
    const studio::Sweep sweep = *sweep_;
    sweep_.reset();
    way_.clear();
    setState(State::HasMask); // for a further way
    if (!studio_.editor().prepareMaterial()) {
        return true;
    }
    studio_.editor().cut(sweep);
    if (!isDrawn()) {
        abandon(); // the same once more would cut nothing
    }
    return true;
}

// A way that was drawn on another view means something else on this one.
void SweepTool::forgetOldView() {
    if (state_ != State::Ready || !sweep_ || sweep_->canvas->view == studio_.view().shown()) {
        return;
    }
    way_.clear();
    sweep_.reset();
    setState(State::HasMask);
    if (!isDrawn()) {
        calm_.start();
    }
}

void SweepTool::clear() {
    if (state_ == State::Ready || state_ == State::DrawingWay) {
        way_.clear();
        sweep_.reset();
        isDrawn() ? setState(State::HasMask) : abandon();
    } else {
        abandon();
    }
}

void SweepTool::abandon() {
    way_.clear();
    sweep_.reset();
    state_ = State::Empty;
    SketchTool::clear();
}

} // namespace vs::desktop

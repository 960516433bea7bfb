// SPDX-License-Identifier: Apache-2.0
#include "model/hand/sketch_pad.h"

#include "model/hand/tool.h"

#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

QPainterPath lineThrough(const std::vector<QPointF>& points) {
    QPainterPath path;
    path.moveTo(points.front());
    for (const QPointF& point : points) {
        path.lineTo(point);
    }
    return path;
}

} // namespace

bool SketchPad::isDrawnByPoints() const { return shape_ == studio::Shape::FreeForm || isPolyline(); }

bool SketchPad::isNear(QPointF place, double pixels) const {
    return pen_ && distance(*pen_, place) <= pixels;
}

// The second of two quick clicks may be farther off: it was not meant as a corner.
bool SketchPad::isAtLastCorner() const {
    return pen_ && isNear(points_.back(), isDoubleClick_ ? kCloses : kSamePlace);
}

bool SketchPad::isLine() const { return needs_ == Needs::Line && isDrawnByPoints(); }

bool SketchPad::canClose() const { return isPolyline() && points_.size() >= 3 && isOfUse(); }

void SketchPad::begin(studio::Shape shape, QPointF at, const std::vector<glm::dvec2>& stencil, Needs needs) {
    clear();
    shape_ = shape;
    stencil_ = stencil;
    needs_ = needs;
    points_ = {at};
    isHeld_ = true;
    if (isPolyline()) {
        pen_ = at;
    } else if (!isDrawnByPoints()) {
        points_.push_back(at);
    }
}

void SketchPad::press(const Pen& pen) {
    isHeld_ = true;
    isDoubleClick_ = pen.isDoubleClick;
    extend(pen.position);
}

void SketchPad::extend(QPointF to) {
    if (points_.empty()) {
        return;
    }
    if (isPolyline()) {
        pen_ = to;
    } else if (!isDrawnByPoints()) {
        points_.back() = to;
    } else if (to != points_.back()) {
        points_.push_back(to);
    }
}

bool SketchPad::end(QPointF at) {
    extend(at);
    isHeld_ = false;
    if (!isPolyline()) {
        return true;
    }
    const bool isAgain = isAtLastCorner();
    isDoubleClick_ = false;
    if (isAtFirstCorner()) {
        if (needs_ == Needs::Line) {
            points_.push_back(points_.front());
        }
        return finish();
    }
    if (isAgain) {
        return finish();
    }
    points_.push_back(at);
    return false;
}

bool SketchPad::finish() {
    if (!isPolyline() || !pen_ || !isOfUse()) {
        return false;
    }
    pen_.reset();
    isHeld_ = false;
    return true;
}

void SketchPad::clear() {
    points_.clear();
    pen_.reset();
    isHeld_ = isDoubleClick_ = false;
}

QRectF SketchPad::box() const {
    if (shape_ == studio::Shape::Circle) {
        const double radius = distance(points_.front(), points_.back());
        return {points_.front() - QPointF(radius, radius), points_.front() + QPointF(radius, radius)};
    }
    const auto [left, right] = std::minmax_element(points_.begin(), points_.end(),
                                                   [](QPointF a, QPointF b) { return a.x() < b.x(); });
    const auto [top, bottom] = std::minmax_element(points_.begin(), points_.end(),
                                                   [](QPointF a, QPointF b) { return a.y() < b.y(); });
    return {QPointF(left->x(), top->y()), QPointF(right->x(), bottom->y())};
}

bool SketchPad::isOfUse() const {
    constexpr double kLeast = 4; // logical pixels: less is a slip of the hand
    if (isLine()) {
        return points_.size() >= (isPolyline() ? 2U : 1U);
    }
    const std::size_t needed = isDrawnByPoints() ? 3 : 2;
    return points_.size() >= needed && box().width() >= kLeast && box().height() >= kLeast;
}

// As large as fits into the box, in its middle.
std::vector<QPointF> SketchPad::fittedStencil() const {
    glm::dvec2 lo = stencil_.front();
    glm::dvec2 hi = lo;
    for (const glm::dvec2 point : stencil_) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    const QRectF into = box();
    const double scale = std::min(into.width() / (hi.x - lo.x), into.height() / (hi.y - lo.y));
    std::vector<QPointF> fitted;
    for (const glm::dvec2 point : stencil_) {
        const glm::dvec2 off = scale * (point - 0.5 * (lo + hi));
        fitted.push_back(into.center() + QPointF(off.x, off.y));
    }
    return fitted;
}

QPainterPath SketchPad::outline() const {
    QPainterPath path;
    if (points_.empty()) {
        return path;
    }
    switch (shape_) {
    case studio::Shape::FreeForm:
        return lineThrough(points_);
    case studio::Shape::Polyline:
        path = lineThrough(points_);
        if (pen_) {
            path.lineTo(isAtFirstCorner() ? points_.front() : *pen_);
        }
        return path;
    case studio::Shape::Stencil:
        return lineThrough(fittedStencil());
    case studio::Shape::Rectangle:
        path.addRect(box());
        return path;
    case studio::Shape::Ellipse:
    case studio::Shape::Circle:
        break;
    }
    path.addEllipse(box());
    return path;
}

QPainterPath SketchPad::area() const {
    if (points_.empty()) {
        return {};
    }
    QPainterPath path = isPolyline() ? lineThrough(points_) : outline();
    if (!isLine() || isAtFirstCorner()) {
        path.closeSubpath();
    }
    path.setFillRule(Qt::OddEvenFill);
    return path;
}

QPainterPath SketchPad::stretchToPen() const {
    return pen_ && !isAtFirstCorner() ? lineThrough({points_.back(), *pen_}) : QPainterPath();
}

QPainterPath SketchPad::firstCorner() const {
    QPainterPath ring;
    if (canClose() && pen_) {
        const double radius = isAtFirstCorner() ? kCloses : 0.5 * kCloses;
        ring.addEllipse(points_.front(), radius, radius);
    }
    return ring;
}

QPointF SketchPad::centre() const { return box().center(); }

studio::Sketch SketchPad::sketch(glm::dvec2 devicePerLogical) const {
    studio::Sketch sketch{shape_, {}};
    for (const QPointF& point : shape_ == studio::Shape::Stencil ? fittedStencil() : points_) {
        sketch.points.emplace_back(glm::dvec2(point.x(), point.y()) * devicePerLogical);
    }
    return sketch;
}

QPainterPath closedPath(const std::vector<glm::dvec2>& pixels, glm::dvec2 devicePerLogical) {
    QPolygonF polygon;
    for (const glm::dvec2 pixel : pixels) {
        const glm::dvec2 logical = pixel / devicePerLogical;
        polygon.append(QPointF(logical.x, logical.y));
    }
    QPainterPath path;
    if (!polygon.isEmpty()) {
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    path.setFillRule(Qt::OddEvenFill);
    return path;
}

} // namespace vs::desktop

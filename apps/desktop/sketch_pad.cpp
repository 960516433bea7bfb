// SPDX-License-Identifier: Apache-2.0
#include "sketch_pad.h"

#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kCloses = 8; // logical pixels from a polyline's first corner
constexpr double kSamePlace = 3;

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

bool SketchPad::isDrawnByPoints() const {
    return stencil_.empty() && (shape_ == studio::Shape::FreeForm || shape_ == studio::Shape::Polyline);
}

void SketchPad::begin(studio::Shape shape, QPointF at, const std::vector<glm::dvec2>& stencil) {
    shape_ = shape;
    stencil_ = stencil;
    points_ = {at};
    if (!isDrawnByPoints() || shape_ == studio::Shape::Polyline) {
        points_.push_back(at);
    }
}

void SketchPad::extend(QPointF to) {
    if (points_.empty()) {
        return;
    }
    if (isDrawnByPoints() && shape_ == studio::Shape::FreeForm) {
        if (to != points_.back()) {
            points_.push_back(to);
        }
    } else {
        points_.back() = to;
    }
}

bool SketchPad::end(QPointF at) {
    extend(at);
    if (!isDrawnByPoints() || shape_ != studio::Shape::Polyline) {
        return true;
    }
    const std::size_t corners = points_.size() - 1; // and the one that follows the pen
    const bool isAgain = distance(at, points_[corners - 1]) <= kSamePlace;
    if (corners >= 3 && (isAgain || distance(at, points_.front()) <= kCloses)) {
        points_.pop_back();
        return true;
    }
    if (!isAgain) {
        points_.push_back(at);
    }
    return false;
}

QRectF SketchPad::box() const {
    if (shape_ == studio::Shape::Circle && stencil_.empty()) {
        const double radius = distance(points_.front(), points_.back());
        return {points_.front() - QPointF(radius, radius), points_.front() + QPointF(radius, radius)};
    }
    const auto [left, right] = std::minmax_element(points_.begin(), points_.end(),
                                                   [](QPointF a, QPointF b) { return a.x() < b.x(); });
    const auto [top, bottom] = std::minmax_element(points_.begin(), points_.end(),
                                                   [](QPointF a, QPointF b) { return a.y() < b.y(); });
    return {QPointF(left->x(), top->y()), QPointF(right->x(), bottom->y())};
}

bool SketchPad::hasArea() const {
    constexpr double kLeast = 4; // logical pixels: less is a slip of the hand
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
    if (!stencil_.empty()) {
        return lineThrough(fittedStencil());
    }
    if (isDrawnByPoints()) {
        return lineThrough(points_);
    }
    if (shape_ == studio::Shape::Rectangle) {
        path.addRect(box());
    } else {
        path.addEllipse(box());
    }
    return path;
}

QPainterPath SketchPad::area() const {
    QPainterPath path = outline();
    path.closeSubpath();
    path.setFillRule(Qt::OddEvenFill);
    return path;
}

QPointF SketchPad::centre() const { return box().center(); }

studio::Sketch SketchPad::sketch(glm::dvec2 devicePerLogical) const {
    const bool isStencil = !stencil_.empty();
    studio::Sketch sketch{isStencil ? studio::Shape::Polyline : shape_, {}};
    for (const QPointF& point : isStencil ? fittedStencil() : points_) {
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

// SPDX-License-Identifier: Apache-2.0
#include "sketch_pad.h"

#include <QPolygonF>

#include <algorithm>

namespace vs::desktop {

void SketchPad::begin(studio::Shape shape, QPointF at) {
    shape_ = shape;
    points_ = {at};
}

void SketchPad::extend(QPointF to) {
    if (shape_ == studio::Shape::FreeForm) {
        if (to != points_.back()) {
            points_.push_back(to);
        }
    } else {
        points_.resize(2);
        points_[1] = to;
    }
}

QRectF SketchPad::box() const {
    const auto [left, right] = std::minmax_element(points_.begin(), points_.end(),
                                                   [](QPointF a, QPointF b) { return a.x() < b.x(); });
    const auto [top, bottom] = std::minmax_element(points_.begin(), points_.end(),
                                                   [](QPointF a, QPointF b) { return a.y() < b.y(); });
    return {QPointF(left->x(), top->y()), QPointF(right->x(), bottom->y())};
}

bool SketchPad::hasArea() const {
    constexpr double kLeast = 4; // logical pixels: less is a slip of the hand
    const std::size_t needed = shape_ == studio::Shape::FreeForm ? 3 : 2;
    return points_.size() >= needed && box().width() >= kLeast && box().height() >= kLeast;
}

QPainterPath SketchPad::outline() const {
    QPainterPath path;
    if (points_.empty()) {
        return path;
    }
    if (shape_ == studio::Shape::FreeForm) {
        path.moveTo(points_.front());
        for (const QPointF& point : points_) {
            path.lineTo(point);
        }
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
    studio::Sketch sketch{shape_, {}};
    for (const QPointF& point : points_) {
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

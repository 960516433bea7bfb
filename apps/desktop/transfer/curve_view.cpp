// SPDX-License-Identifier: Apache-2.0
#include "transfer/curve_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kReach = 8;  // pixels in which a point is caught
constexpr double kRadius = 5; // of a point
constexpr double kUnder = 8;  // so far below the curve a hill is caught
constexpr double kStill = 3;  // pixels that a click may move
} // namespace

QPointF CurveView::placeOf(const render::ControlPoint& point) const {
    return {xOf(point.position), area().bottom() - point.opacity * area().height()};
}

double CurveView::opacityAt(double y) const {
    return std::clamp((area().bottom() - y) / area().height(), 0.0, 1.0);
}

std::optional<std::size_t> CurveView::pointAt(QPointF place) const {
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t i = 0; i < function().points.size(); ++i) {
        const double distance = QLineF(place, placeOf(function().points[i])).length();
        // Of points in one place the one that can be moved away: towards the side that the pen is on.
        if (distance < least ||
            (nearest && distance == least && place.x() > placeOf(function().points[i]).x())) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::optional<render::Hill> CurveView::hillAt(QPointF place) const {
    return render::hillAt(function(), valueAt(place.x()), opacityAt(place.y() - kUnder));
}

void CurveView::addAt(QPointF place) {
    std::size_t added = 0;
    change([&](render::TransferFunction& f) {
        added = render::addPoint(f, valueAt(place.x()), opacityAt(place.y()));
    });
    editor().choose(kind(), added);
}

void CurveView::addPart() {
    editor().begin();
    const Range at{shown().lo + 0.4 * shown().width(), shown().lo + 0.6 * shown().width()};
    render::Hill box;
    change([&](render::TransferFunction& f) { box = render::addBox(f, at, 0.5, render::nextSafeColour(f)); });
    editor().choose(kind(), box.first + 1);
}

void CurveView::removeChosen() {
    const auto point = chosen();
    if (!point) {
        return;
    }
    change([&](render::TransferFunction& f) { render::removePoint(f, *point); });
    editor().choose(kind(), *point > 0 ? *point - 1 : 0);
}

void CurveView::moveChosen(glm::dvec2 steps) {
    const auto point = function().points.at(*chosen());
    change([&](render::TransferFunction& f) {
        render::movePoint(f, *chosen(), point.position + steps.x * smallestStep(),
                          point.opacity + 0.01 * steps.y);
    });
}

void CurveView::mousePressEvent(QMouseEvent* event) {
    if (isEmpty()) {
        return;
    }
    const QPointF place = event->position();
    const auto point = pointAt(place);
    editor().begin();
    hasMoved_ = false;
    pressed_ = place;
    before_ = function();
    if (event->button() == Qt::RightButton && point) {
        editor().choose(kind(), point);
        removeChosen();
    } else if (event->button() != Qt::LeftButton) {
        return;
    } else if (point) {
        grip_ = Grip::Point;
        offset_ = placeOf(function().points[*point]) - place;
        editor().choose(kind(), point);
    } else if (const auto hill = hillAt(place)) {
        grip_ = Grip::Hill;
        hill_ = *hill;
        setCursor(Qt::ClosedHandCursor);
    } else {
        grip_ = Grip::Point;
        offset_ = {};
        addAt(place);
    }
}

void CurveView::dragHill(QPointF to) {
    const double by = valueAt(to.x()) - valueAt(pressed_.x());
    // What was taken hold of follows the pen up and down.
    const double times = std::max(opacityAt(to.y()), 0.001) / std::max(opacityAt(pressed_.y()), 0.02);
    change([&](render::TransferFunction& f) {
        f = before_;
        render::moveHill(f, hill_, by, std::abs(to.y() - pressed_.y()) < kStill ? 1 : times);
    });
}

void CurveView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF to = event->position();
    if (grip_ == Grip::None) {
        const bool isOver = !isEmpty() && area().contains(to);
        setCursor(!isOver       ? Qt::ArrowCursor
                  : pointAt(to) ? Qt::SizeAllCursor
                  : hillAt(to)  ? Qt::OpenHandCursor
                                : Qt::CrossCursor);
        return;
    }
    hasMoved_ = hasMoved_ || QLineF(pressed_, to).length() > kStill;
    if (!hasMoved_) {
        return;
    }
    if (grip_ == Grip::Hill) {
        dragHill(to);
    } else if (const auto point = chosen()) {
        const QPointF place = to + offset_;
        change([&](render::TransferFunction& f) {
            render::movePoint(f, *point, valueAt(place.x()), opacityAt(place.y()));
        });
    }
}

void CurveView::mouseReleaseEvent(QMouseEvent* event) {
    if (grip_ == Grip::Hill && !hasMoved_) {
        addAt(event->position()); // a click adds, wherever it is
    }
    grip_ = Grip::None;
    unsetCursor();
}

void CurveView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && chosen()) {
        emit colourWanted();
    }
}

void CurveView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintFrame(painter);
    if (isEmpty()) {
        return;
    }
    paintBars(painter, nullptr);
    painter.save();
    painter.setOpacity(strength());
    painter.setClipRect(area().adjusted(-kRadius - 1, -kRadius, kRadius + 1, kRadius + 1));
    paintCurve(painter);
    paintPoints(painter);
    painter.restore();
    paintAxis(painter);
}

// The area under the curve in its own colours, so that one sees what a value will look like.
void CurveView::paintCurve(QPainter& painter) const {
    const render::FunctionSampler sampler(function());
    const QRectF plot = area();
    QLinearGradient colours(plot.topLeft(), plot.topRight());
    constexpr int kStops = 64;
    for (int i = 0; i <= kStops; ++i) {
        const double value = shown().lo + shown().width() * i / kStops;
        QColor colour = screenColour(render::colourFromLinear(glm::dvec3(sampler.at(value, value))));
        colour.setAlphaF(0.6F);
        colours.setColorAt(double(i) / kStops, colour);
    }
    QPolygonF line;
    line << QPointF(plot.left(), placeOf(function().points.front()).y());
    for (const render::ControlPoint& point : function().points) {
        line << placeOf(point);
    }
    line << QPointF(plot.right(), line.back().y());
    // Beyond the ends of what is shown the line goes on; where the first or last point lies outside, its
    // level was drawn from the border.
    line.front().setX(std::min(plot.left(), line[1].x()));
    line.back().setX(std::max(plot.right(), line[line.size() - 2].x()));
    QPolygonF filled = line;
    filled << QPointF(line.back().x(), plot.bottom()) << QPointF(line.front().x(), plot.bottom());
    QPainterPath path;
    path.addPolygon(filled);
    painter.save();
    painter.setClipRect(plot, Qt::IntersectClip);
    painter.fillPath(path, colours);
    painter.restore();
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    painter.drawPolyline(line);
}

void CurveView::paintPoints(QPainter& painter) const {
    const render::FunctionSampler sampler(function());
    const auto& points = function().points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double at = points[i].position;
        const bool isChosen = chosen() == i;
        painter.setPen(
            QPen(palette().color(isChosen ? QPalette::Link : QPalette::Text), isChosen ? 2.5 : 1.5));
        painter.setBrush(screenColour(render::colourFromLinear(glm::dvec3(sampler.at(at, at)))));
        const double radius = isChosen ? kRadius + 1 : kRadius;
        painter.drawEllipse(placeOf(points[i]), radius, radius);
    }
}

} // namespace vs::desktop

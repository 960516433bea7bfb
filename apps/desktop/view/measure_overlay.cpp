// SPDX-License-Identifier: Apache-2.0
#include "view/measure_overlay.h"

#include "parts/theme.h"
#include "tools/measure_tool.h"
#include "view/paint_overlay.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <vector>

namespace vs::desktop {

namespace {

// A dark tag with the value, beside the line's middle or the angle's corner, and below the tags that stand
// there already.
void paintLabel(QPainter& painter, QPointF at, const QString& text, QRectF area, std::vector<QRectF>& tags) {
    const QFontMetricsF metrics(painter.font());
    QRectF box = metrics.boundingRect(text).adjusted(-5, -2, 5, 2);
    box.moveTopLeft(at + QPointF(9, 7));
    box.moveRight(std::min(box.right(), area.right() - 4));
    box.moveBottom(std::min(box.bottom(), area.bottom() - 4));
    const auto overlaps = [&box](const QRectF& other) { return other.intersects(box); };
    while (std::any_of(tags.begin(), tags.end(), overlaps) && box.bottom() + box.height() < area.bottom()) {
        box.translate(0, box.height() + 1);
    }
    tags.push_back(box);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(10, 12, 14, 190));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(theme::kPen);
    painter.drawText(box, Qt::AlignCenter, text);
}

// Where places were put: all of those that were clicked, both ends of what was drawn.
void addDots(QPainterPath& line, const std::vector<QPointF>& points, studio::Measure::Kind kind) {
    constexpr double kDot = 2.5;
    const bool isDrawn = kind == studio::Measure::Kind::Path || kind == studio::Measure::Kind::Area ||
                         kind == studio::Measure::Kind::Vessel;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (!isDrawn || n == 0 || n + 1 == points.size()) {
            line.addEllipse(points[n], kDot, kDot);
        }
    }
}

// At an angle's corner, below an outline, else half-way along.
QPointF labelPlace(const studio::Measured& measured, const std::vector<QPointF>& points) {
    if (measured.measure.kind == studio::Measure::Kind::Angle) {
        return points[1];
    }
    if (measured.isArea()) {
        return *std::max_element(points.begin(), points.end(),
                                 [](QPointF a, QPointF b) { return a.y() < b.y(); });
    }
    return points.size() == 2 ? 0.5 * (points[0] + points[1]) : points[points.size() / 2];
}

// Where a vessel is narrow, and how much.
void paintNarrowing(QPainter& painter, QPointF at, const QString& text, QRectF area,
                    std::vector<QRectF>& tags) {
    constexpr double kSize = 5;
    QPainterPath diamond;
    diamond.addPolygon(QPolygonF({at + QPointF(kSize, 0), at + QPointF(0, kSize), at - QPointF(kSize, 0),
                                  at - QPointF(0, kSize), at + QPointF(kSize, 0)}));
    paintOverlay(painter, {diamond, Overlay::Tint::Cutting, 0.6, 1.5}, area);
    paintLabel(painter, at, text, area, tags);
}

} // namespace

void paintMeasurements(QPainter& painter, const MeasureTool& tool,
                       const std::function<std::optional<QPointF>(glm::dvec3)>& seenAt, QRectF area) {
    std::vector<QRectF> tags; // that were painted
    const auto paint = [&](const studio::Measured& measured, bool isInHand) {
        QPainterPath line;
        std::vector<QPointF> points;
        for (const glm::dvec3 place : measured.world) {
            const auto point = seenAt(place);
            if (!point) {
                return;
            }
            points.push_back(*point);
        }
        if (points.empty()) {
            return; // what is cut has no place
        }
        line.addPolygon(QPolygonF(QVector<QPointF>(points.begin(), points.end())));
        if (measured.isArea() && !isInHand) {
            line.closeSubpath();
        } else {
            addDots(line, points, measured.measure.kind);
        }
        const double filled = measured.isArea() ? 0.15 : 0;
        paintOverlay(painter, {line, isInHand ? Overlay::Tint::Pen : Overlay::Tint::Seed, filled, 1.5}, area);
        if (measured.value > 0) {
            paintLabel(painter, labelPlace(measured, points), tool.labelOf(measured), area, tags);
        }
        if (measured.isNarrowed()) {
            paintNarrowing(painter, points[measured.narrowest->index], tool.narrowestOf(measured), area,
                           tags);
        }
    };
    for (const studio::Measured& measured : tool.measurements()) {
        paint(measured, false);
    }
    if (const auto inHand = tool.inHand()) {
        paint(*inHand, true);
    }
}

} // namespace vs::desktop

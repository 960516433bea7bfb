// SPDX-License-Identifier: Apache-2.0
#include "view/measure_overlay.h"

#include "parts/theme.h"
#include "tools/measure_tool.h"
#include "view/paint_overlay.h"

#include <QFontMetricsF>
#include <QPainter>

namespace vs::desktop {

namespace {

// A dark tag with the value, beside the line's middle or the angle's corner.
void paintLabel(QPainter& painter, QPointF at, const QString& text, QRectF area) {
    const QFontMetricsF metrics(painter.font());
    QRectF box = metrics.boundingRect(text).adjusted(-5, -2, 5, 2);
    box.moveTopLeft(at + QPointF(9, 7));
    box.moveRight(std::min(box.right(), area.right() - 4));
    box.moveBottom(std::min(box.bottom(), area.bottom() - 4));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(10, 12, 14, 190));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(theme::kPen);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace

void paintMeasurements(QPainter& painter, const MeasureTool& tool,
                       const std::function<std::optional<QPointF>(glm::dvec3)>& seenAt, QRectF area) {
    const auto paint = [&](const Measurement& measurement, bool isInHand) {
        QPainterPath line;
        std::vector<QPointF> points;
        for (const glm::dvec3 place : measurement.places) {
            const auto point = seenAt(place);
            if (!point) {
                return;
            }
            points.push_back(*point);
        }
        line.moveTo(points.front());
        for (const QPointF point : points) {
            line.lineTo(point);
            line.addEllipse(point, 2.5, 2.5);
            line.moveTo(point);
        }
        paintOverlay(painter, {line, isInHand ? Overlay::Tint::Pen : Overlay::Tint::Seed, 0, 1.5}, area);
        const QPointF middle = measurement.isAngle() ? points[1] : 0.5 * (points.front() + points.back());
        if (valueOf(measurement) > 0) {
            paintLabel(painter, middle, labelOf(measurement), area);
        }
    };
    for (const Measurement& measurement : tool.measurements()) {
        paint(measurement, false);
    }
    if (tool.inHand()) {
        paint(*tool.inHand(), true);
    }
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "paint_overlay.h"

#include "theme.h"
#include "tool.h"

#include <QPainter>

namespace vs::desktop {

namespace {

QColor colourOf(Overlay::Tint tint) {
    switch (tint) {
    case Overlay::Tint::Pen:
        return theme::kPen;
    case Overlay::Tint::Idle:
        return theme::kIdle;
    case Overlay::Tint::Cutting:
        return theme::kCutting;
    case Overlay::Tint::Seed:
        break;
    }
    return theme::kSeed;
}

} // namespace

void paintOverlay(QPainter& painter, const Overlay& overlay) {
    if (overlay.path.isEmpty()) {
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = colourOf(overlay.tint);
    if (overlay.isFilled) {
        QColor fill = colour;
        fill.setAlphaF(0.22F); // what is cut must be seen through it
        painter.fillPath(overlay.path, fill);
    }
    // A dark edge on both sides of the line shows it on any background.
    constexpr double kEdge = 1.5;
    QColor edge = Qt::black;
    edge.setAlphaF(0.65F);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(edge, overlay.width + 2 * kEdge, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(overlay.path);
    painter.setPen(QPen(colour, overlay.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(overlay.path);
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "view/paint_overlay.h"

#include "model/hand/tool.h"
#include "parts/theme.h"

#include <QImage>
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
    case Overlay::Tint::ReadyToRestore:
        return theme::kRestore;
    case Overlay::Tint::Restoring:
        return theme::kRestoring;
    case Overlay::Tint::Seed:
        break;
    }
    return theme::kSeed;
}

} // namespace

void paintOverlay(QPainter& painter, const Overlay& overlay, QRectF area) {
    if (overlay.path.isEmpty()) {
        return;
    }
    // A dark edge on both sides of the line shows it on any background.
    constexpr double kEdge = 1.5;
    const double outer = overlay.width + 2 * kEdge;
    // Drawn on the CPU and put on the picture as an image: on OpenGL, QPainter smooths edges only with
    // multisampling, which costs more here than a small image.
    const double scale = painter.device()->devicePixelRatioF();
    const QRect box =
        overlay.path.boundingRect().adjusted(-outer, -outer, outer, outer).intersected(area).toAlignedRect();
    if (box.isEmpty()) {
        return;
    }
    QImage image(box.size() * scale, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(scale);
    image.fill(Qt::transparent);
    QPainter onImage(&image);
    onImage.setRenderHint(QPainter::Antialiasing);
    onImage.translate(-box.topLeft());
    const QColor colour = colourOf(overlay.tint);
    if (overlay.fill > 0) {
        QColor fill = colour;
        fill.setAlphaF(float(overlay.fill));
        onImage.fillPath(overlay.path, fill);
    }
    if (overlay.width > 0) {
        QColor edge = Qt::black;
        edge.setAlphaF(0.65F);
        onImage.setPen(QPen(edge, outer, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        onImage.drawPath(overlay.path);
        onImage.setPen(QPen(colour, overlay.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        onImage.drawPath(overlay.path);
    }
    onImage.end();
    painter.drawImage(box.topLeft(), image);
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
// What a slice shows: picture, crosshair, directions, measurements, the pen.
#include "model/slices/slice_controller.h"
#include "parts/theme.h"
#include "tools/measure_tool.h"
#include "view/measure_overlay.h"
#include "view/paint_overlay.h"
#include "view/slice_canvas.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr int kFileAxis = 2;          // of voxels, along which files of slices lie
constexpr QColor kBehind{11, 13, 15}; // as the pictures have it outside the grid

// Text that is read on any picture.
void drawText(QPainter& painter, QRectF box, int flags, const QString& text) {
    painter.setPen(QColor(0, 0, 0, 190));
    for (const QPointF offset : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)}) {
        painter.drawText(box.translated(offset), flags, text);
    }
    painter.setPen(theme::kPen);
    painter.drawText(box, flags, text);
}

} // namespace

QColor sliceColour(render::SliceKind kind) {
    constexpr QColor colours[] = {{0xee, 0x6c, 0x4a}, {0x2f, 0xc9, 0x8f}, {0xe8, 0xc5, 0x47}};
    return colours[static_cast<int>(kind)];
}

void SliceCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QImage& picture = slices_.picture(kind_);
    if (picture.isNull() || !slices_.hasVolume()) {
        painter.fillRect(rect(), kBehind);
        return;
    }
    painter.drawImage(QRectF(rect()), picture, QRectF(picture.rect()));
    painter.setRenderHint(QPainter::Antialiasing);
    paintCrosshair(painter);
    paintInterpolated(painter);
    setProperty("report", isInterpolated() ? "interpolated" : QString());
    paintLetters(painter);
    paintWindow(painter);
    paintMeasurements(
        painter, measureTool_, [this](glm::dvec3 world) { return seenAt(world); }, QRectF(rect()));
    paintPen(painter);
}

// Nothing for what lies on another slice.
std::optional<QPointF> SliceCanvas::seenAt(glm::dvec3 world) const {
    const glm::dvec3 voxel = slices_.voxelAt(world);
    const int axis = slices_.geometry(kind_).axis();
    constexpr double kNear = 0.51;
    return std::abs(voxel[axis] - slices_.crosshair()[axis]) < kNear
               ? std::optional(pointOf(slices_.geometry(kind_).placeOf(voxel)))
               : std::nullopt;
}

void SliceCanvas::paintCrosshair(QPainter& painter) const {
    const render::SliceGeometry own = slices_.geometry(kind_);
    const glm::dvec3 centre(slices_.crosshair());
    const QPointF at = pointOf(own.placeOf(centre));
    constexpr double kGap = 9;
    for (const auto kind : render::kSliceKinds) {
        const int along = slices_.geometry(kind).axis(); // which the other slice lies across
        if (kind == kind_) {
            continue;
        }
        // The two meet in a line along the third axis.
        glm::dvec3 further = centre;
        further[3 - along - own.axis()] += 1;
        const QPointF step = pointOf(own.placeOf(further)) - at;
        const QPointF way = step / std::max(std::hypot(step.x(), step.y()), 1e-9);
        const double reach = width() + height() + std::hypot(at.x(), at.y());
        QColor colour = sliceColour(kind);
        colour.setAlpha(190);
        painter.setPen(QPen(colour, 1));
        painter.drawLine(at + kGap * way, at + reach * way);
        painter.drawLine(at - kGap * way, at - reach * way);
    }
}

// No file holds the slice that is shown.
bool SliceCanvas::isInterpolated() const {
    return slices_.geometry(kind_).axis() == kFileAxis &&
           std::ranges::binary_search(slices_.interpolated(), slices_.crosshair()[kFileAxis]);
}

// Slices that no file holds have a rim of their own; on those across them it is marked where they are.
void SliceCanvas::paintInterpolated(QPainter& painter) const {
    constexpr double kRim = 3;
    if (isInterpolated()) {
        painter.setPen(QPen(theme::kInterpolated, 2 * kRim));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect());
        painter.setFont(font());
        drawText(painter, QRectF(rect()).adjusted(7, 6, -9, -4), Qt::AlignRight | Qt::AlignTop,
                 tr("interpolated"));
    }
    const render::SliceGeometry own = slices_.geometry(kind_);
    if (own.axis() == kFileAxis) {
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::kInterpolated);
    for (const int slice : slices_.interpolated()) {
        glm::dvec3 voxel(slices_.crosshair());
        voxel[kFileAxis] = slice - 0.5;
        const QPointF from = pointOf(own.placeOf(voxel));
        voxel[kFileAxis] = slice + 0.5;
        const QPointF to = pointOf(own.placeOf(voxel));
        if (own.downAxis() == kFileAxis) {
            painter.drawRect(QRectF(QPointF(0, from.y()), QPointF(kRim, to.y())).normalized());
            painter.drawRect(
                QRectF(QPointF(width() - kRim, from.y()), QPointF(width(), to.y())).normalized());
        } else {
            painter.drawRect(QRectF(QPointF(from.x(), 0), QPointF(to.x(), kRim)).normalized());
            painter.drawRect(
                QRectF(QPointF(from.x(), height() - kRim), QPointF(to.x(), height())).normalized());
        }
    }
}

void SliceCanvas::paintLetters(QPainter& painter) const {
    const auto letters = slices_.geometry(kind_).letters();
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const QRectF box = QRectF(rect()).adjusted(7, 4, -7, -4);
    const auto draw = [&](int flags, const std::string& text) {
        drawText(painter, box, flags, QString::fromStdString(text));
    };
    draw(Qt::AlignLeft | Qt::AlignVCenter, letters.left);
    draw(Qt::AlignRight | Qt::AlignVCenter, letters.right);
    draw(Qt::AlignHCenter | Qt::AlignTop, letters.top);
    draw(Qt::AlignHCenter | Qt::AlignBottom, letters.bottom);
}

// As radiologists read it: level and width.
void SliceCanvas::paintWindow(QPainter& painter) const {
    const Range window = slices_.window();
    const int decimals = std::max(0, 2 - int(std::floor(std::log10(std::max(window.width(), 1e-9)))));
    painter.setFont(font());
    drawText(painter, QRectF(rect()).adjusted(7, 4, -7, -4), Qt::AlignLeft | Qt::AlignBottom,
             tr("L %1  W %2")
                 .arg(0.5 * (window.lo + window.hi), 0, 'f', decimals)
                 .arg(window.width(), 0, 'f', decimals));
}

// The stroke in hand, or the brush where the pen is.
void SliceCanvas::paintPen(QPainter& painter) const {
    const double pointsPerMm = 1 / (slices_.view(kind_).pixelMm * devicePixelRatioF());
    if (const auto& stroke = pen_.stroke(); stroke && stroke->kind == kind_) {
        QPainterPath way(pointOf(stroke->places.front()));
        for (const glm::dvec2 place : stroke->places) {
            way.lineTo(pointOf(place));
        }
        if (stroke->places.size() == 1) {
            way.lineTo(way.currentPosition() + QPointF(0.01, 0)); // a dot
        }
        QPainterPathStroker stroker;
        stroker.setWidth(std::max(2 * stroke->radiusMm * pointsPerMm, 1.5));
        stroker.setCapStyle(Qt::RoundCap);
        stroker.setJoinStyle(Qt::RoundJoin);
        const QPainterPath covered = stroker.createStroke(way).simplified();
        paintOverlay(painter, {covered, stroke->tint, 0.35, 1}, QRectF(rect()));
    } else if (const auto radius = pen_.radiusMm(kind_); radius && under_ && drag_ == Drag::None) {
        QPainterPath brush;
        const double reach = std::max(*radius * pointsPerMm, 1.0);
        brush.addEllipse(*under_, reach, reach);
        paintOverlay(painter, {brush, pen_.tint(false), 0.1, 1}, QRectF(rect()));
    }
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "slice_canvas.h"

#include "paint_overlay.h"
#include "slice_controller.h"
#include "theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace vs::desktop {

namespace {

constexpr QColor kBehind{11, 13, 15}; // as the pictures have it outside the grid
constexpr int kFastSlices = 10;       // with Shift

// Text that is read on any picture.
void drawText(QPainter& painter, QRectF box, int flags, const QString& text) {
    painter.setPen(QColor(0, 0, 0, 190));
    for (const QPointF offset : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)}) {
        painter.drawText(box.translated(offset), flags, text);
    }
    painter.setPen(theme::kText);
    painter.drawText(box, flags, text);
}

} // namespace

QColor sliceColour(render::SliceKind kind) {
    constexpr QColor colours[] = {{0xee, 0x6c, 0x4a}, {0x2f, 0xc9, 0x8f}, {0xe8, 0xc5, 0x47}};
    return colours[static_cast<int>(kind)];
}

SliceCanvas::SliceCanvas(SliceController& slices, SlicePen& pen, render::SliceKind kind, QWidget* parent)
    : QWidget(parent), slices_(slices), pen_(pen), kind_(kind) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::CrossCursor);
    setMinimumSize(120, 90);
    connect(&slices_, &SliceController::changed, this, qOverload<>(&QWidget::update));
    connect(&slices_, &SliceController::pictureChanged, this, [this](render::SliceKind drawn) {
        if (drawn == kind_) {
            update();
        }
    });
    connect(&pen_, &SlicePen::changed, this, qOverload<>(&QWidget::update));
}

// --- places

QPointF SliceCanvas::placeInWidget(QPointF inWindow) const {
    const double half = 0.5 / devicePixelRatioF(); // a mouse reports a pixel's corner
    return mapFrom(window(), inWindow) + QPointF(half, half);
}

glm::dvec2 SliceCanvas::placeAt(QPointF inWidget) const {
    const double scale = devicePixelRatioF();
    return slices_.view(kind_).placeAt({inWidget.x() * scale, inWidget.y() * scale});
}

QPointF SliceCanvas::pointOf(glm::dvec2 place) const {
    const glm::dvec2 pixel = slices_.view(kind_).pixelOf(place) / devicePixelRatioF();
    return {pixel.x, pixel.y};
}

std::optional<glm::dvec2> SliceCanvas::placeUnderPen() const {
    return under_ ? std::optional(placeAt(*under_)) : std::nullopt;
}

void SliceCanvas::tellViewport() {
    const QSize pixels = size() * devicePixelRatioF();
    slices_.setViewport(kind_, {pixels.width(), pixels.height()}, devicePixelRatioF());
}

void SliceCanvas::resizeEvent(QResizeEvent*) { tellViewport(); }

void SliceCanvas::showEvent(QShowEvent*) {
    tellViewport();
    slices_.setShown(kind_, true);
}

void SliceCanvas::hideEvent(QHideEvent*) { slices_.setShown(kind_, false); }

// --- painting

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
    paintLetters(painter);
    paintPen(painter);
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

// The stroke in hand, or the brush where the pen is.
void SliceCanvas::paintPen(QPainter& painter) const {
    const double pointsPerMm = 1 / (slices_.view(kind_).pixelMm * devicePixelRatioF());
    if (const auto& stroke = pen_.stroke(); stroke && stroke->kind == kind_) {
        QPainterPath way(pointOf(stroke->places.front()));
        for (const glm::dvec2 place : stroke->places) {
            way.lineTo(pointOf(place));
        }
        way.lineTo(way.currentPosition() + QPointF(0.01, 0)); // one place alone is a dot
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

// --- mouse and keys

void SliceCanvas::mousePressEvent(QMouseEvent* event) {
    if (drag_ != Drag::None || !slices_.hasVolume()) {
        return; // a second button changes nothing
    }
    button_ = event->button();
    last_ = placeInWidget(event->scenePosition());
    under_ = last_;
    const bool isRight = button_ == Qt::RightButton;
    if (button_ == Qt::LeftButton || (isRight && pen_.takesRightButton())) {
        drag_ = pen_.press(kind_, placeAt(last_), isRight, event->modifiers()) ? Drag::Pen : Drag::None;
    } else if (button_ == Qt::MiddleButton) {
        drag_ = Drag::Pan;
    } else if (isRight) {
        drag_ = Drag::Zoom;
    }
}

void SliceCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF now = placeInWidget(event->scenePosition());
    const QPointF moved = now - last_;
    if (drag_ == Drag::Pen) {
        pen_.move(kind_, placeAt(now));
    } else if (drag_ == Drag::Pan) {
        slices_.pan(kind_, placeAt(last_) - placeAt(now));
    } else if (drag_ == Drag::Zoom) {
        slices_.zoom(kind_, std::exp(-0.008 * moved.y()), slices_.view(kind_).centreMm); // up to come nearer
    } else if (pen_.radiusMm(kind_)) {
        update();
    }
    last_ = now;
    under_ = now;
    emit penMoved();
}

void SliceCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != button_) {
        return;
    }
    const bool isPen = drag_ == Drag::Pen;
    drag_ = Drag::None;
    button_ = Qt::NoButton;
    if (isPen) {
        pen_.release();
    }
    emit penMoved();
}

void SliceCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !pen_.radiusMm(kind_)) {
        emit enlargeRequested();
    } else {
        mousePressEvent(event);
    }
}

void SliceCanvas::wheelEvent(QWheelEvent* event) {
    event->accept();
    if (!slices_.hasVolume()) {
        return;
    }
    // With Alt Qt turns the wheel sideways.
    const QPoint turned = event->angleDelta();
    const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        constexpr double kPerNotch = 1.2;
        slices_.zoom(kind_, std::pow(kPerNotch, notches), placeAt(event->position()));
        return;
    }
    wheel_ += notches;
    const int whole = int(std::trunc(wheel_));
    wheel_ -= whole;
    slices_.scroll(kind_, whole * (event->modifiers().testFlag(Qt::ShiftModifier) ? kFastSlices : 1));
}

// By a voxel, as the picture lies.
void SliceCanvas::moveCrosshair(int right, int down) {
    const render::SliceGeometry slice = slices_.geometry(kind_);
    glm::dvec3 next(slices_.crosshair());
    const auto along = [](double perMm) { return perMm < 0 ? -1 : 1; };
    next[slice.acrossAxis()] += right * along(slice.voxelsPerMmRight()[slice.acrossAxis()]);
    next[slice.downAxis()] += down * along(slice.voxelsPerMmDown()[slice.downAxis()]);
    slices_.setCrosshair(next);
}

void SliceCanvas::keyPressEvent(QKeyEvent* event) {
    const int slices = event->modifiers().testFlag(Qt::ShiftModifier) ? kFastSlices : 1;
    if (!slices_.hasVolume()) {
        return;
    }
    switch (event->key()) {
    case Qt::Key_PageUp:
        slices_.scroll(kind_, slices);
        break;
    case Qt::Key_PageDown:
        slices_.scroll(kind_, -slices);
        break;
    case Qt::Key_Left:
        moveCrosshair(-slices, 0);
        break;
    case Qt::Key_Right:
        moveCrosshair(slices, 0);
        break;
    case Qt::Key_Up:
        moveCrosshair(0, -slices);
        break;
    case Qt::Key_Down:
        moveCrosshair(0, slices);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void SliceCanvas::leaveEvent(QEvent*) {
    under_.reset();
    update();
    emit penMoved();
}

} // namespace vs::desktop

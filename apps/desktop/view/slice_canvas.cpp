// SPDX-License-Identifier: Apache-2.0
#include "view/slice_canvas.h"

#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"
#include "tools/measure_tool.h"
#include "tools/tool_box.h"

#include <QLineF>
#include <QMenu>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace vs::desktop {

namespace {

constexpr int kFastSlices = 10; // with Shift

} // namespace

SliceCanvas::SliceCanvas(StudioController& studio, ToolBox& tools, render::SliceKind kind, QWidget* parent)
    : QWidget(parent), studio_(studio), slices_(studio.slices()), pen_(tools.slicePen()),
      measureTool_(tools.get<MeasureTool>()), kind_(kind) {
    setMouseTracking(true);
    setTabletTracking(true);
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
    connect(&measureTool_, &MeasureTool::changed, this, qOverload<>(&QWidget::update));
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

// --- pen, mouse and keys

void SliceCanvas::press(QPointF place, bool isReversed, Qt::KeyboardModifiers modifiers) {
    under_ = pressed_ = last_ = place;
    pressedWindow_ = slices_.window();
    const bool isOfWindow = button_ == Qt::RightButton && modifiers.testFlag(Qt::ShiftModifier);
    if (button_ == Qt::LeftButton || (isReversed && pen_.takesRightButton() && !isOfWindow)) {
        drag_ = pen_.press(kind_, placeAt(last_), isReversed, modifiers) ? Drag::Pen : Drag::None;
    } else {
        drag_ = dragOf(button_, modifiers);
    }
}

SliceCanvas::Drag SliceCanvas::dragOf(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    if (button == Qt::RightButton) {
        return modifiers.testFlag(Qt::ControlModifier) ? Drag::Zoom : Drag::Window;
    }
    return button == Qt::MiddleButton ? Drag::Pan : Drag::None;
}

void SliceCanvas::move(QPointF now) {
    const QPointF moved = now - last_;
    last_ = now;
    under_ = now;
    if (drag_ == Drag::Pen) {
        pen_.move(kind_, placeAt(now));
    } else if (drag_ == Drag::Pan) {
        slices_.pan(kind_, placeAt(now - moved) - placeAt(now));
    } else if (drag_ == Drag::Zoom) {
        slices_.zoom(kind_, std::exp(-0.008 * moved.y()), slices_.view(kind_).centreMm); // up to come nearer
    } else if (drag_ == Drag::Window) {
        const QPointF led = now - pressed_;
        if (isDrag()) {
            slices_.leadWindow(pressedWindow_, {led.x(), led.y()});
        }
    } else if (slices_.hasVolume()) {
        pen_.hover(kind_, placeAt(now));
        update(); // the brush is where the pen is
    }
    emit penMoved();
}

void SliceCanvas::release() {
    const Drag ended = std::exchange(drag_, Drag::None);
    button_ = Qt::NoButton;
    if (ended == Drag::Pen) {
        pen_.release(isDrag());
    } else if (ended == Drag::Window && !isDrag()) {
        offerWindows();
    }
    emit penMoved();
}

bool SliceCanvas::isDrag() const {
    constexpr double kDragPixels = 4; // less is a click
    return QLineF(pressed_, last_).length() > kDragPixels;
}

void SliceCanvas::offerWindows() {
    auto* menu = named(new QMenu(this), "sliceWindows", tr("Windows of slices"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(actions());
    menu->popup(mapToGlobal(last_.toPoint()));
}

void SliceCanvas::mousePressEvent(QMouseEvent* event) {
    if (drag_ != Drag::None || !slices_.hasVolume()) {
        return; // a second button changes nothing
    }
    button_ = event->button();
    press(placeInWidget(event->scenePosition()), button_ == Qt::RightButton, event->modifiers());
}

void SliceCanvas::mouseMoveEvent(QMouseEvent* event) { move(placeInWidget(event->scenePosition())); }

void SliceCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == button_) {
        release();
    }
}

// Finer than pixels, and with an eraser at the pen's other end.
void SliceCanvas::tabletEvent(QTabletEvent* event) {
    const bool isEraser = event->pointerType() == QPointingDevice::PointerType::Eraser;
    studio_.hand().setTabletPressure(event->pressure());
    switch (event->type()) {
    case QEvent::TabletPress:
        if (drag_ == Drag::None && slices_.hasVolume()) {
            button_ = event->button();
            press(event->position(), isEraser || button_ == Qt::RightButton, event->modifiers());
        }
        break;
    case QEvent::TabletRelease:
        if (event->button() == button_) {
            release();
        }
        break;
    default:
        move(event->position());
    }
    event->accept(); // or Qt would make a mouse event of it too
}

void SliceCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !pen_.takesDoubleClick()) {
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

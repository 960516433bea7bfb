// SPDX-License-Identifier: Apache-2.0
#include "view/view_widget.h"

#include "model/document/camera_motion.h"
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/camera_tool.h"
#include "tools/measure_tool.h"
#include "tools/tool_box.h"
#include "view/measure_overlay.h"
#include "view/paint_overlay.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <QWheelEvent>

#include <cmath>

namespace vs::desktop {

ViewWidget::ViewWidget(StudioController& studio, ToolBox& tools, QWidget* parent)
    : QWidget(parent), studio_(studio), tools_(tools), cube_(studio) {
    setObjectName("view");
    setAccessibleName(tr("Picture of the volume"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setTabletTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 240);
    // At once: an update that is only asked for waits behind the work on the next picture.
    connect(&studio_, &StudioController::pictureChanged, this, qOverload<>(&QWidget::repaint));
    connect(&studio_.hand(), &Hand::overlayChanged, this, [this] {
        showCursor();
        if (!studio_.isPictureComing()) { // which is painted together with it
            update();
        }
    });
    showCursor();
}

void ViewWidget::showCursor() {
    setCursor(cube_.pointedAt() ? Qt::PointingHandCursor : studio_.hand().tool().cursor());
}

glm::ivec2 ViewWidget::deviceSize() const {
    const QSize size = this->size() * devicePixelRatioF();
    return {size.width(), size.height()};
}

bool ViewWidget::event(QEvent* event) {
    if (event->type() == QEvent::ScreenChangeInternal) { // perhaps of another scale
        studio_.view().setViewport(QSizeF(size()), deviceSize());
    }
    return QWidget::event(event);
}

void ViewWidget::resizeEvent(QResizeEvent*) { studio_.view().setViewport(QSizeF(size()), deviceSize()); }

void ViewWidget::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QImage& picture = studio_.picture().shown();
    if (picture.isNull()) {
        painter.fillRect(rect(), Qt::black);
    } else {
        // Drafts are enlarged; a picture that has the view's pixels is copied.
        painter.setRenderHint(QPainter::SmoothPixmapTransform,
                              glm::ivec2(picture.width(), picture.height()) != deviceSize());
        painter.drawImage(QRectF(rect()), picture, QRectF(picture.rect()));
    }
    const auto* geometry = studio_.host().geometry();
    if (!picture.isNull() && isAnnotated_ && geometry != nullptr) {
        annotations_.paint(painter, {studio_.view().shown().camera, *geometry, cube_.pointedAt()},
                           deviceSize());
    }
    if (geometry != nullptr) {
        paintMeasurements(
            painter, tools_.get<MeasureTool>(), [this](glm::dvec3 world) { return seenAt(world); },
            QRectF(rect()));
    }
    for (const auto& overlays : {studio_.slices().overlays(), studio_.hand().tool().overlays()}) {
        for (const Overlay& overlay : overlays) {
            paintOverlay(painter, overlay, QRectF(rect()));
        }
    }
    painter.end();
    emit painted();
}

// Nothing for what is behind the viewer.
std::optional<QPointF> ViewWidget::seenAt(glm::dvec3 world) const {
    const auto rays = studio_.view().rays();
    const double nearest = studio_.host().geometry()->stepMm();
    const bool isBehind = !rays.isOrthographic && glm::dot(world - rays.eye, rays.forward) < nearest;
    return isBehind ? std::nullopt : std::optional(studio_.view().seenAt(world));
}

void ViewWidget::setAnnotated(bool isAnnotated) {
    isAnnotated_ = isAnnotated;
    pointAtCube({});
    update();
}

Pen ViewWidget::penAt(QPointF inWindow, Qt::KeyboardModifiers modifiers) const {
    // From the place in the window, because Qt rounds a mouse's place in the widget to whole logical pixels.
    // A mouse reports a pixel's corner; what the person points with is its middle.
    const double half = 0.5 / devicePixelRatioF();
    return {mapFrom(window(), inWindow) + QPointF(half, half),
            studio_.hand().mousePressure(),
            {},
            true,
            modifiers};
}

void ViewWidget::press(const Pen& pen, Drag drag) {
    const bool moves = drag == Drag::Pan || drag == Drag::Zoom;
    drag_ = moves && studio_.hand().tool().isSketching() ? Drag::None : drag; // the picture holds still
    last_ = pressed_ = pen.position;
    if (drag == Drag::Tool && studio_.host().document() != nullptr && !studio_.host().isLoading()) {
        studio_.hand().tool().press(pen);
    } else if (drag == Drag::Tool) {
        drag_ = Drag::None;
    }
}

// Not while a tool has something in hand: its next stroke may begin on the cube.
void ViewWidget::pointAtCube(const std::optional<QPointF>& place) {
    const Tool& tool = studio_.hand().tool();
    if (cube_.point(isAnnotated_ && !tool.isSketching() && !tool.isBusy() ? place : std::nullopt)) {
        showCursor();
        update();
    }
}

bool ViewWidget::pressOnCube(const Pen& pen) {
    pointAtCube(pen.position);
    if (!cube_.pointedAt() || studio_.host().isLoading() || !cube_.press(pen.position)) {
        return false;
    }
    drag_ = Drag::Cube;
    return true;
}

void ViewWidget::move(const Pen& pen) {
    penPosition_ = pen.position;
    const QPointF delta = pen.position - last_;
    last_ = pen.position;
    switch (drag_) {
    case Drag::None:
        if (studio_.hand().tool().isSketching() && !hasFocus()) { // its keys end what is under way
            setFocus(Qt::MouseFocusReason);
        }
        pointAtCube(pen.position);
        cube_.pointedAt() ? studio_.hand().tool().leave() : studio_.hand().tool().hover(pen);
        break;
    case Drag::Tool:
        studio_.hand().tool().move(pen);
        break;
    case Drag::Pan:
        studio_.camera().pan(delta);
        break;
    case Drag::Zoom:
        studio_.camera().zoom(CameraMotion::zoomBy(delta.y()), pressed_);
        break;
    case Drag::Cube:
        cube_.move(pen.position);
        break;
    }
    emit penMoved();
}

void ViewWidget::release(const Pen& pen) {
    if (drag_ == Drag::Tool) {
        studio_.hand().tool().release(pen);
    } else if (drag_ == Drag::Cube) {
        cube_.release();
        showCursor();
        update();
    }
    drag_ = Drag::None;
    button_ = Qt::NoButton;
    emit penMoved();
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
    if (drag_ != Drag::None) {
        return; // a second button changes nothing
    }
    button_ = event->button();
    Pen pen = penAt(event->scenePosition(), event->modifiers());
    pen.isDoubleClick = event->type() == QEvent::MouseButtonDblClick;
    if (button_ == Qt::LeftButton && pressOnCube(pen)) {
        return;
    }
    if (button_ == Qt::LeftButton) {
        const bool isPan = pen.modifiers.testFlag(Qt::ShiftModifier) && !studio_.hand().tool().takesShift();
        press(pen, isPan ? Drag::Pan : Drag::Tool);
    } else if (button_ == Qt::MiddleButton) {
        press(pen, Drag::Pan);
    } else if (button_ == Qt::RightButton) {
        press(pen, Drag::Zoom);
    }
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
    move(penAt(event->scenePosition(), event->modifiers()));
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == button_) {
        release(penAt(event->scenePosition(), event->modifiers()));
    }
}

// With the camera tool the slices go to the surface under the pen.
void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) {
    pointAtCube(penAt(event->scenePosition(), {}).position);
    const bool centres = !cube_.pointedAt() && event->button() == Qt::LeftButton &&
                         studio_.slices().isAnyShown() && &studio_.hand().tool() == &tools_.get<CameraTool>();
    if (!centres || !studio_.slices().centreOnSurface(penAt(event->scenePosition(), {}).position)) {
        mousePressEvent(event);
    }
}

void ViewWidget::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    // A wheel's place in the window is wrong where Qt passes the event on to a child.
    const Pen pen = penAt(mapTo(window(), event->position()), event->modifiers());
    if (drag_ == Drag::None && !studio_.hand().tool().isSketching() &&
        !studio_.hand().tool().wheel(notches, pen)) {
        constexpr double kPerNotch = 1.2;
        studio_.camera().zoom(std::pow(kPerNotch, notches), pen.position);
    }
    event->accept();
}

void ViewWidget::tabletEvent(QTabletEvent* event) {
    const Pen pen{event->position(), // already finer than pixels
                  event->pressure(), QPointF(event->xTilt(), event->yTilt()), false, event->modifiers()};
    studio_.hand().setTabletPressure(event->pressure());
    switch (event->type()) {
    case QEvent::TabletPress:
        if (drag_ == Drag::None) {
            button_ = event->button();
            if (button_ != Qt::LeftButton || !pressOnCube(pen)) {
                press(pen, button_ == Qt::LeftButton ? Drag::Tool : Drag::Pan);
            }
        }
        break;
    case QEvent::TabletRelease:
        if (event->button() == button_) {
            release(pen);
        }
        break;
    default:
        move(pen);
    }
    event->accept(); // or Qt would make a mouse event of it too
}

void ViewWidget::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isEnter || !studio_.hand().tool().accept()) {
        QWidget::keyPressEvent(event);
    }
}

bool ViewWidget::focusNextPrevChild(bool next) {
    return studio_.hand().tool().next(next) || QWidget::focusNextPrevChild(next);
}

void ViewWidget::leaveEvent(QEvent*) {
    penPosition_.reset();
    if (drag_ == Drag::None) {
        pointAtCube({});
        studio_.hand().tool().leave();
    }
    emit penMoved();
}

} // namespace vs::desktop

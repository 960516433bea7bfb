// SPDX-License-Identifier: Apache-2.0
#include "view/camera_keys.h"

#include "model/document/camera_motion.h"
#include "model/hand/tool.h"
#include "model/studio/studio_controller.h"

#include <QKeyEvent>
#include <QWidget>

namespace vs::desktop {

namespace {
constexpr double kTurnPixels = 15; // as a drag by so many would
constexpr double kMovePixels = 25;
constexpr double kRollDegrees = 5;
constexpr double kZoom = 1.2;
} // namespace

CameraKeys::CameraKeys(QWidget& view, StudioController& studio) : QObject(&view), studio_(studio) {
    view.installEventFilter(this);
}

bool CameraKeys::eventFilter(QObject* watched, QEvent* event) {
    return (event->type() == QEvent::KeyPress && press(*static_cast<QKeyEvent*>(event))) ||
           QObject::eventFilter(watched, event);
}

bool CameraKeys::press(const QKeyEvent& event) {
    if (studio_.host().document() == nullptr || studio_.hand().tool().isBusy()) {
        return false; // the picture holds still under a stroke
    }
    const auto zoom = [&](double factor) {
        studio_.camera().zoom(factor, studio_.view().centre());
        return true;
    };
    const auto arrow = [&](int right, int down) {
        if (event.modifiers().testFlag(Qt::ControlModifier)) {
            studio_.camera().roll(kRollDegrees * right, studio_.view().centre());
        } else if (event.modifiers().testFlag(Qt::ShiftModifier)) {
            studio_.camera().pan(kMovePixels * QPointF(right, down));
        } else {
            studio_.camera().turn(kTurnPixels * QPointF(right, down));
        }
        return true;
    };
    switch (event.key()) {
    case Qt::Key_Left:
        return arrow(-1, 0);
    case Qt::Key_Right:
        return arrow(1, 0);
    case Qt::Key_Up:
        return arrow(0, -1);
    case Qt::Key_Down:
        return arrow(0, 1);
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the same key without Shift on many keyboards
        return zoom(kZoom);
    case Qt::Key_Minus:
        return zoom(1 / kZoom);
    default:
        return false;
    }
}

} // namespace vs::desktop

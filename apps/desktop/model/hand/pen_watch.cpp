// SPDX-License-Identifier: Apache-2.0
#include "model/hand/pen_watch.h"

#include "model/hand/hand.h"
#include "model/hand/tool.h"

#include <QApplication>
#include <QTabletEvent>

namespace vs::desktop {

PenWatch::PenWatch(Hand& hand, QObject* parent) : QObject(parent), hand_(hand) {
    qApp->installEventFilter(this);
}

bool PenWatch::isPenNear() const {
    return isDown_ || (isNear_ && sinceReport_.milliseconds() < kForgottenMs);
}

bool PenWatch::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        isDown_ = event->type() != QEvent::TabletRelease &&
                  static_cast<QTabletEvent*>(event)->buttons() != Qt::NoButton;
        see(static_cast<QTabletEvent*>(event)->pointerType() == QPointingDevice::PointerType::Eraser);
        break;
    case QEvent::TabletEnterProximity:
        see(static_cast<QTabletEvent*>(event)->pointerType() == QPointingDevice::PointerType::Eraser);
        break;
    case QEvent::TabletLeaveProximity:
        see(false);
        isNear_ = isDown_ = false;
        break;
    default:
        break;
    }
    return false;
}

void PenWatch::see(bool isEraser) {
    isNear_ = true;
    sinceReport_ = Timer();
    Tool& tool = hand_.tool();
    if (!tool.isBusy()) { // a stroke goes on as it was begun
        turn(isEraser && tool.hasSign() ? &tool : nullptr);
    }
}

void PenWatch::turn(Tool* tool) {
    if (tool == turned_) {
        return;
    }
    for (Tool* changing : {turned_.data(), tool}) {
        if (changing != nullptr) {
            changing->setReversed(!changing->isReversed());
        }
    }
    turned_ = tool;
}

} // namespace vs::desktop

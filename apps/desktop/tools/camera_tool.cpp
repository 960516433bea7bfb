// SPDX-License-Identifier: Apache-2.0
#include "tools/camera_tool.h"

#include "model/document/camera_motion.h"
#include "model/studio/studio_controller.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

// Of the view's smaller side, and in logical pixels: how wide the rim is.
constexpr double kRim = 0.06;
constexpr double kLeastRim = 20;
constexpr double kMostRim = 48;

double degreesAt(QPointF fromCentre) {
    return std::atan2(fromCentre.y(), fromCentre.x()) * 180 / 3.14159265358979323846;
}

} // namespace

CameraTool::CameraTool(StudioController& studio) : StudioTool(studio) {}

QString CameraTool::hint() const {
    if (isRimShown_) {
        return tr("Drag along the rim to roll the picture.");
    }
    switch (use_) {
    case Use::Move:
        return tr("Drag to move the picture, along the rim to roll. Wheel or right button zooms.");
    case Use::Zoom:
        return tr("Drag up to come nearer, down to step back, along the rim to roll.");
    case Use::Turn:
        break;
    }
    return tr("Drag to turn, along the rim to roll. Middle button or Shift+drag moves, wheel or right "
              "button zooms, whatever the tool.");
}

void CameraTool::setUse(Use use) {
    use_ = use;
    emit overlayChanged(); // the hint
    emit studio_.host().changed();
}

Qt::CursorShape CameraTool::cursor() const {
    return drag_ != Drag::None ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
}

bool CameraTool::isAtRim(QPointF place) const {
    const QPointF half = studio_.view().centre();
    const double width = std::clamp(kRim * 2 * std::min(half.x(), half.y()), kLeastRim, kMostRim);
    const QPointF fromCentre = place - half;
    return std::abs(fromCentre.x()) > half.x() - width || std::abs(fromCentre.y()) > half.y() - width;
}

// A circle around the middle that rolling goes along, broken at the axes that it turns from.
Overlays CameraTool::overlays() const {
    if (!isRimShown_) {
        return {};
    }
    const QPointF centre = studio_.view().centre();
    const double radius = 0.94 * std::min(centre.x(), centre.y());
    const QRectF around(centre - QPointF(radius, radius), centre + QPointF(radius, radius));
    QPainterPath path;
    constexpr double gap = 6; // degrees
    for (int quarter = 0; quarter < 4; ++quarter) {
        path.arcMoveTo(around, 90 * quarter + gap);
        path.arcTo(around, 90 * quarter + gap, 90 - 2 * gap);
    }
    return {{path, Overlay::Tint::Pen, 0, 1.5}};
}

void CameraTool::showRim(bool isShown) {
    if (isShown != isRimShown_) {
        isRimShown_ = isShown;
        emit overlayChanged();
    }
}

void CameraTool::hover(const Pen& pen) {
    showRim(studio_.host().geometry() != nullptr && isAtRim(pen.position));
}

void CameraTool::leave() { showRim(false); }

void CameraTool::press(const Pen& pen) {
    pressed_ = last_ = pen.position;
    drag_ = isAtRim(pen.position) ? Drag::Roll : Drag::Use;
    isRimShown_ = drag_ == Drag::Roll;
    emit overlayChanged();
}

void CameraTool::move(const Pen& pen) {
    const QPointF centre = studio_.view().centre();
    const QPointF delta = pen.position - last_;
    CameraMotion& camera = studio_.camera();
    if (drag_ == Drag::Roll) {
        const double degrees = degreesAt(pen.position - centre) - degreesAt(last_ - centre);
        camera.roll(std::remainder(degrees, 360.0), centre);
    } else if (use_ == Use::Move) {
        camera.pan(delta);
    } else if (use_ == Use::Zoom) {
        camera.zoom(CameraMotion::zoomBy(delta.y()), pressed_);
    } else {
        camera.turn(delta);
    }
    last_ = pen.position;
}

void CameraTool::release(const Pen& pen) {
    drag_ = Drag::None;
    isRimShown_ = isAtRim(pen.position);
    emit overlayChanged();
}

void CameraTool::clear() {
    drag_ = Drag::None;
    showRim(false);
}

} // namespace vs::desktop

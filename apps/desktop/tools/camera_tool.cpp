// SPDX-License-Identifier: Apache-2.0
#include "tools/camera_tool.h"

#include "model/studio/studio_controller.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kDegreesPerPixel = 0.35; // half a turn for a hand's width
constexpr double kLeastZoom = 0.1;
constexpr double kMostZoom = 100;
} // namespace

CameraTool::CameraTool(StudioController& studio) : StudioTool(studio) {}

QString CameraTool::hint() const {
    return tr(
        "Drag to turn. Middle button or Shift+drag moves, wheel or right button zooms, whatever the tool.");
}

Qt::CursorShape CameraTool::cursor() const { return isDragging_ ? Qt::ClosedHandCursor : Qt::OpenHandCursor; }

void CameraTool::press(const Pen& pen) {
    last_ = pen.position;
    isDragging_ = true;
    emit overlayChanged();
}

void CameraTool::move(const Pen& pen) {
    turn(pen.position - last_);
    last_ = pen.position;
}

void CameraTool::release(const Pen&) {
    isDragging_ = false;
    emit overlayChanged();
}

void CameraTool::turn(QPointF delta) {
    auto view = studio_.view().shown();
    // As the hand moves in the picture before it is rolled.
    const double roll = glm::radians(view.camera.rollDegrees);
    const double across = std::cos(roll) * delta.x() + std::sin(roll) * delta.y();
    const double down = std::cos(roll) * delta.y() - std::sin(roll) * delta.x();
    // The surface follows the hand, so the viewer goes the other way.
    view.camera.azimuthDegrees =
        std::remainder(view.camera.azimuthDegrees - kDegreesPerPixel * across, 360.0);
    view.camera.elevationDegrees =
        std::clamp(view.camera.elevationDegrees + kDegreesPerPixel * down, -90.0, 90.0);
    studio_.view().showView(view);
}

void CameraTool::pan(QPointF delta) {
    auto view = studio_.view().shown();
    const glm::dvec2 moved = studio_.view().millimetresPerPixel() * glm::dvec2(-delta.x(), delta.y());
    view.camera.panMm += moved;
    studio_.view().showView(view);
}

void CameraTool::zoom(double factor, QPointF anchor) {
    auto view = studio_.view().shown();
    const double before = view.camera.zoom;
    view.camera.zoom = std::clamp(before * factor, kLeastZoom, kMostZoom);
    view.camera.panMm += millimetresFromCentre(anchor) * (1 - before / view.camera.zoom);
    studio_.view().showView(view);
}

void CameraTool::roll(double degrees, QPointF anchor) {
    auto view = studio_.view().shown();
    const glm::dvec2 offset = millimetresFromCentre(anchor);
    const glm::dvec2 held = view.camera.panMm + offset; // the place under the anchor
    const double by = glm::radians(degrees);
    const glm::dvec2 turned{std::cos(by) * held.x + std::sin(by) * held.y,
                            std::cos(by) * held.y - std::sin(by) * held.x};
    view.camera.rollDegrees = std::remainder(view.camera.rollDegrees + degrees, 360.0);
    view.camera.panMm = turned - offset;
    studio_.view().showView(view);
}

glm::dvec2 CameraTool::millimetresFromCentre(QPointF place) const {
    const QPointF fromCentre = place - studio_.view().centre();
    return studio_.view().millimetresPerPixel() * glm::dvec2(fromCentre.x(), -fromCentre.y());
}

void CameraTool::reset() {
    auto view = studio_.view().shown();
    view.camera = render::Camera{};
    studio_.view().showView(view);
}

} // namespace vs::desktop

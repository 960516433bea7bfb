// SPDX-License-Identifier: Apache-2.0
#include "model/document/camera_motion.h"

#include "model/document/document_host.h"
#include "model/document/view_model.h"

#include "render/camera/fit.h"
#include "render/camera/orbit.h"
#include "studio/document/document.h"
#include "studio/document/document_facts.h"
#include "studio/document/part_queries.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::desktop {

namespace {

constexpr double kDegreesPerPixel = 0.35; // half a turn for a hand's width
constexpr double kFarthest = 0.1;         // zooms
constexpr double kNearest = 100;
constexpr double kAroundAll = 0.04; // of the view, around what is fitted into it
constexpr glm::dvec3 kFromFace{0, -1, 0};

} // namespace

CameraMotion::CameraMotion(DocumentHost& host, ViewModel& view) : host_(host), view_(view) {
    connect(&host_, &DocumentHost::leaving, this, &CameraMotion::forget);
    connect(&host_, &DocumentHost::corrected, this, &CameraMotion::noteCorrection);
    connect(&view_, &ViewModel::resized, this, &CameraMotion::fitAgain);
}

std::vector<StandardView> CameraMotion::standardViews() {
    return {{"anterior", tr("Anterior"), tr("Look at the face"), "Ctrl+1", kFromFace},
            {"posterior", tr("Posterior"), tr("Look from behind"), "Ctrl+2", {0, 1, 0}},
            {"left", tr("Left"), tr("Look at the patient's left"), "Ctrl+3", {1, 0, 0}},
            {"right", tr("Right"), tr("Look at the patient's right"), "Ctrl+4", {-1, 0, 0}},
            {"superior", tr("Superior"), tr("Look from above"), "Ctrl+5", {0, 0, 1}},
            {"inferior", tr("Inferior"), tr("Look from below, as at axial slices"), "Ctrl+6", {0, 0, -1}}};
}

void CameraMotion::forget() {
    seen_.clear();
    fitted_.reset();
    framed_.reset();
}

// What was seen lies elsewhere.
void CameraMotion::noteCorrection() {
    wasFitted_ = isFitted();
    forget();
}

void CameraMotion::fitAfterCorrection() {
    if (std::exchange(wasFitted_, false)) {
        fit();
    }
}

void CameraMotion::show(const render::Camera& camera) {
    auto view = view_.shown();
    view.camera = camera;
    view_.showView(view);
}

// --- turning

bool CameraMotion::isFitted() const { return fitted_ == view_.shown().camera; }

bool CameraMotion::isFramed() const { return framed_ == view_.shown().camera; }

// The middle of what was seen when it was fitted, else of the grid.
glm::dvec3 CameraMotion::pivot() const {
    if (seen_.empty()) {
        return host_.geometry()->centreWorld();
    }
    glm::dvec3 lo = seen_.front();
    glm::dvec3 hi = lo;
    for (const glm::dvec3 point : seen_) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    return 0.5 * (lo + hi);
}

void CameraMotion::turnTo(const render::Camera& turned) {
    if (host_.geometry() == nullptr) {
        return;
    }
    const bool wasFramed = isFramed();
    const auto& camera = view_.shown().camera;
    const auto around = render::aroundPivot(camera, turned, pivot(), *host_.geometry(), kNearest);
    if (wasFramed) {
        framed_ = around;
    }
    show(around);
}

void CameraMotion::turn(QPointF delta) {
    const auto& camera = view_.shown().camera;
    if (!isTurntable_) {
        turnTo(render::tumbled(camera, kDegreesPerPixel * glm::dvec3(delta.y(), delta.x(), 0)));
        return;
    }
    // As the hand moves in the picture before it is rolled.
    const double roll = glm::radians(camera.rollDegrees);
    const double across = std::cos(roll) * delta.x() + std::sin(roll) * delta.y();
    const double down = std::cos(roll) * delta.y() - std::sin(roll) * delta.x();
    // The surface follows the hand, so the viewer goes the other way.
    auto turned = camera;
    turned.azimuthDegrees = std::remainder(camera.azimuthDegrees - kDegreesPerPixel * across, 360.0);
    turned.elevationDegrees = std::clamp(camera.elevationDegrees + kDegreesPerPixel * down, -90.0, 90.0);
    turnTo(turned);
}

void CameraMotion::roll(double degrees, QPointF anchor) {
    auto camera = view_.shown().camera;
    const glm::dvec2 offset = millimetresFromCentre(anchor);
    const glm::dvec2 held = camera.panMm + offset; // the place under the anchor
    const double by = glm::radians(degrees);
    const glm::dvec2 turned{std::cos(by) * held.x + std::sin(by) * held.y,
                            std::cos(by) * held.y - std::sin(by) * held.x};
    camera.rollDegrees = std::remainder(camera.rollDegrees + degrees, 360.0);
    camera.panMm = turned - offset;
    if (isFramed()) {
        framed_ = camera;
    }
    show(camera);
}

void CameraMotion::lookFrom(glm::dvec3 direction) {
    const bool wasFramed = isFramed();
    const auto turned = render::lookingFrom(view_.shown().camera, direction);
    if (wasFramed) {
        fitted_ = framed_ = fittedOn(turned);
        show(*fitted_);
    } else {
        turnTo(turned);
    }
}

// --- moving

void CameraMotion::pan(QPointF delta) {
    auto camera = view_.shown().camera;
    camera.panMm += view_.millimetresPerPixel() * glm::dvec2(-delta.x(), delta.y());
    show(camera);
}

void CameraMotion::zoom(double factor, QPointF anchor) {
    auto camera = view_.shown().camera;
    const double before = camera.zoom;
    camera.zoom = std::clamp(before * factor, kFarthest, kNearest);
    camera.panMm += millimetresFromCentre(anchor) * (1 - before / camera.zoom);
    show(camera);
}

glm::dvec2 CameraMotion::millimetresFromCentre(QPointF place) const {
    const QPointF fromCentre = place - view_.centre();
    return view_.millimetresPerPixel() * glm::dvec2(fromCentre.x(), -fromCentre.y());
}

bool CameraMotion::isOrthographic() const {
    return view_.shown().camera.projection == render::Projection::Orthographic;
}

void CameraMotion::setOrthographic(bool isOrthographic) {
    const bool wasFramed = isFramed();
    auto camera = view_.shown().camera;
    camera.projection = isOrthographic ? render::Projection::Orthographic : render::Projection::Perspective;
    if (wasFramed) {
        fitted_ = framed_ = fittedOn(camera);
        camera = *fitted_;
    }
    show(camera);
}

// --- fitting

render::Camera CameraMotion::fittedOn(const render::Camera& camera) const {
    return render::fitted(camera, *host_.geometry(), glm::max(view_.viewport(), glm::ivec2(1)), seen_,
                          kAroundAll, kNearest);
}

void CameraMotion::fit() {
    if (host_.geometry() == nullptr || host_.facts()->isStrokeOpen()) {
        return; // the picture holds still under a stroke
    }
    view_.flush();
    if (host_.workLong([this] { seen_ = host_.document()->parts().pointsAroundAll(); })) {
        fitted_ = framed_ = fittedOn(view_.shown().camera);
        show(*fitted_);
    }
}

// The view has another size: what was fitted and has not been touched since is fitted again.
void CameraMotion::fitAgain() {
    if (host_.geometry() != nullptr && isFitted()) {
        fitted_ = framed_ = fittedOn(*fitted_);
        show(*fitted_);
    }
}

void CameraMotion::reset() {
    if (host_.geometry() == nullptr) {
        return;
    }
    show(render::lookingFrom(view_.shown().camera, kFromFace));
    fit();
}

} // namespace vs::desktop

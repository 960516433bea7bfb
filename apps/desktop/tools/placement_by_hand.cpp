// SPDX-License-Identifier: Apache-2.0
#include "tools/placement_by_hand.h"

#include "model/hand/world_lines.h"

#include <QPolygonF>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kLeastScale = 0.1;
constexpr double kMostScale = 10;

glm::dquat turnOf(const glm::dvec3& degrees) {
    const double angle = glm::length(degrees);
    return angle > 0 ? glm::angleAxis(glm::radians(angle), degrees / angle) : glm::dquat(1, 0, 0, 0);
}

// By the shorter way round.
glm::dvec3 degreesOf(glm::dquat turn) {
    if (turn.w < 0) {
        turn = -turn;
    }
    const double angle = glm::degrees(glm::angle(turn));
    return angle > 1e-9 ? angle * glm::axis(turn) : glm::dvec3(0);
}

} // namespace

glm::dvec3 HeldPart::centre() const {
    return glm::dvec3(render::worldFromPart(place_, *geometry_) * glm::dvec4(centre_, 1.0));
}

void HeldPart::turn(glm::dvec3 axis, double degrees) {
    const glm::dvec3 held = centre();
    place_.turnDegrees = degreesOf(glm::angleAxis(glm::radians(degrees), axis) * turnOf(place_.turnDegrees));
    keepCentreAt(held);
}

void HeldPart::scale(double factor) {
    const glm::dvec3 held = centre();
    place_.scale = std::clamp(place_.scale * factor, kLeastScale, kMostScale);
    keepCentreAt(held);
}

void HeldPart::keepCentreAt(glm::dvec3 world) { place_.moveMm += world - centre(); }

QRectF seenBox(const Box3& part, const render::Placement& place, const volume::GridGeometry& geometry,
               const render::ViewRays& rays) {
    QPolygonF seen;
    const glm::dmat4 worldFromVoxel = render::worldFromPart(place, geometry) * geometry.worldFromVoxel;
    for (const auto& corner : boxCorners(glm::dvec3(part.lo), glm::dvec3(part.hi), worldFromVoxel)) {
        const glm::dvec2 pixel = rays.project(corner);
        seen.append(QPointF(pixel.x, pixel.y));
    }
    return seen.boundingRect();
}

} // namespace vs::desktop

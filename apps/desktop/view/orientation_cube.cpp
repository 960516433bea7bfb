// SPDX-License-Identifier: Apache-2.0
#include "view/orientation_cube.h"

#include "model/document/camera_motion.h"
#include "model/studio/studio_controller.h"

#include "render/marks/orientation_marker.h"

#include <QLineF>

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr double kDragged = 4; // pixels: less is a click
} // namespace

bool OrientationCube::point(const std::optional<QPointF>& place) {
    std::optional<glm::dvec3> zone;
    if (place && studio_.host().geometry() != nullptr) {
        const glm::dvec2 density = studio_.view().devicePerLogical();
        zone = render::zoneAt(studio_.view().rays(), glm::dvec2(place->x(), place->y()) * density, density.y);
    }
    const bool isNew = zone != pointedAt_;
    pointedAt_ = zone;
    return isNew;
}

QPointF OrientationCube::placeOf(glm::dvec3 zone) const {
    const auto rays = studio_.view().rays();
    const glm::dvec2 density = studio_.view().devicePerLogical();
    const auto marker = render::orientationMarker(rays, density.y);
    // On the cube from -1 to 1, at the middle of the zone: the cube's corner, the middle of its edge or face.
    const glm::dvec3 onCube = zone / std::max({std::abs(zone.x), std::abs(zone.y), std::abs(zone.z)});
    const glm::dvec2 seen{glm::dot(onCube, glm::normalize(rays.right)),
                          -glm::dot(onCube, glm::normalize(rays.up))};
    constexpr double inside = 0.9; // not on its very border
    const glm::dvec2 place = (marker.centre + inside * marker.halfEdge * seen) / density;
    return {place.x, place.y};
}

bool OrientationCube::press(QPointF place) {
    point(place);
    pressed_ = last_ = place;
    isDragged_ = false;
    return pointedAt_.has_value();
}

void OrientationCube::move(QPointF place) {
    isDragged_ = isDragged_ || QLineF(pressed_, place).length() > kDragged;
    if (isDragged_) {
        pointedAt_.reset();
        studio_.camera().turn(place - last_);
        last_ = place;
    }
}

void OrientationCube::release() {
    if (pointedAt_) {
        studio_.camera().lookFrom(*pointedAt_);
        pointedAt_.reset(); // another is under the pen now
    }
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "render/camera/orbit.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vs::render {

namespace {

constexpr double kAtPole = 1e-9; // sine of the angle to it

// The viewer's upward and rightward directions before the picture is rolled.
glm::dvec3 uprightOf(double azimuth, double elevation) {
    return {-std::sin(azimuth) * std::sin(elevation), std::cos(azimuth) * std::sin(elevation),
            std::cos(elevation)};
}
glm::dvec3 levelOf(double azimuth) { return {std::cos(azimuth), std::sin(azimuth), 0}; }

} // namespace

glm::dmat3 viewerAxes(const Camera& camera) {
    const double azimuth = glm::radians(camera.azimuthDegrees);
    const double elevation = glm::radians(camera.elevationDegrees);
    // LPS: x left, y posterior, z superior. The face looks along -y.
    const glm::dvec3 back{std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                          std::sin(elevation)};
    const glm::dvec3 upright = uprightOf(azimuth, elevation);
    const glm::dvec3 level = levelOf(azimuth);
    const double roll = glm::radians(camera.rollDegrees);
    return {std::sin(roll) * upright + std::cos(roll) * level,
            std::cos(roll) * upright - std::sin(roll) * level, back};
}

Camera withAxes(const Camera& camera, const glm::dmat3& axes) {
    const glm::dvec3 up = axes[1];
    const glm::dvec3 back = axes[2];
    const double across = std::hypot(back.x, back.y);
    const double azimuth =
        across > kAtPole ? std::atan2(back.x, -back.y) : glm::radians(camera.azimuthDegrees);
    const double elevation = std::atan2(back.z, across);
    const double roll =
        std::atan2(-glm::dot(up, levelOf(azimuth)), glm::dot(up, uprightOf(azimuth, elevation)));
    Camera turned = camera;
    turned.azimuthDegrees = glm::degrees(azimuth);
    turned.elevationDegrees = glm::degrees(elevation);
    turned.rollDegrees = glm::degrees(roll);
    return turned;
}

Camera tumbled(const Camera& camera, glm::dvec3 degrees) {
    const double angle = glm::length(degrees);
    if (angle == 0) {
        return camera;
    }
    const glm::dmat3 axes = viewerAxes(camera);
    // What is seen turns one way when the viewer goes the other way around it.
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), -glm::radians(angle), axes * (degrees / angle)));
    return withAxes(camera, turn * axes);
}

Camera lookingFrom(const Camera& camera, glm::dvec3 direction) {
    const glm::dvec3 back = glm::normalize(direction);
    Camera looking = camera;
    looking.rollDegrees = 0;
    const double across = std::hypot(back.x, back.y);
    if (across > kAtPole) {
        looking.azimuthDegrees = glm::degrees(std::atan2(back.x, -back.y));
        looking.elevationDegrees = glm::degrees(std::atan2(back.z, across));
    } else { // the azimuth that has anterior up
        looking.azimuthDegrees = back.z > 0 ? 180 : 0;
        looking.elevationDegrees = back.z > 0 ? 90 : -90;
    }
    return looking;
}

Camera aroundPivot(const Camera& before, const Camera& turned, glm::dvec3 pivot,
                   const volume::GridGeometry& geometry, double mostZoom) {
    const glm::dvec3 centre = geometry.centreWorld();
    const glm::dvec3 eye = viewRays(before, geometry, glm::ivec2(1)).eye;
    const glm::dmat3 axes = viewerAxes(turned);
    const glm::dvec3 toPivot = glm::transpose(viewerAxes(before)) * (pivot - eye);
    const glm::dvec3 moved = glm::transpose(axes) * (pivot - axes * toPivot - centre);
    Camera around = turned;
    around.panMm = moved;
    if (before.projection == Projection::Perspective) { // zoom is what the viewer's distance is told by
        const double distance = glm::dot(eye - centre, viewerAxes(before)[2]);
        const double least = distance * before.zoom / mostZoom;
        around.zoom = before.zoom * distance / std::max(moved.z, least);
    }
    return around;
}

} // namespace vs::render

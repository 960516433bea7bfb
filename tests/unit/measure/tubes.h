// SPDX-License-Identifier: Apache-2.0
// Tubes whose axes, lengths and diameters are known, and how wrong a vessel along one is.
#pragma once

#include "masks.h"
#include "segment/measures/vessel.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vs::segment {

using Solid = std::function<bool(glm::dvec3 world)>;

inline VoxelSet setWhere(const volume::GridGeometry& grid, const Solid& isInside) {
    return {grid.box(), labelsWhere(grid, [&](glm::dvec3 place) { return isInside(place) ? 1 : 0; })};
}

// A grid about the origin whose axes are turned and, besides, mirrored.
inline volume::GridGeometry turnedGrid(double sizeMm, glm::dvec3 spacing) {
    auto grid = centredGrid(sizeMm, spacing);
    auto turn = glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, -1)));
    turn[0] *= -1.0;
    grid.worldFromVoxel = turn * grid.worldFromVoxel;
    return grid;
}

inline glm::ivec3 voxelAt(const volume::GridGeometry& grid, glm::dvec3 world) {
    return glm::ivec3(glm::round(glm::dvec3(grid.voxelFromWorld() * glm::dvec4(world, 1))));
}
inline glm::dvec3 worldAt(const volume::GridGeometry& grid, glm::dvec3 voxel) {
    return glm::dvec3(grid.worldFromVoxel * glm::dvec4(voxel, 1));
}

// A straight tube through `middle`, cut off flat.
struct Straight {
    glm::dvec3 direction{0, 0, 1};
    std::function<double(double along)> radius;
    double half = 25;
    glm::dvec3 middle{0};

    [[nodiscard]] double along(glm::dvec3 place) const { return glm::dot(place - middle, direction); }
    [[nodiscard]] double off(glm::dvec3 place) const {
        return glm::length(place - middle - along(place) * direction);
    }
    bool operator()(glm::dvec3 place) const {
        return std::abs(along(place)) <= half && off(place) < radius(along(place));
    }
};

inline Straight straight(glm::dvec3 direction, double radius, double half) {
    return {glm::normalize(direction), [radius](double) { return radius; }, half};
}

// What is wrong with a vessel along a straight tube, in steps.
struct Errors {
    double diameter = 0, meanDiameter = 0, axis = 0, length = 0;
};
inline Errors errorsOf(const Vessel& vessel, const volume::GridGeometry& grid, const Straight& tube) {
    Errors errors;
    for (const VesselPoint& point : vessel.points) {
        const glm::dvec3 place = worldAt(grid, point.voxel);
        const double wrong = point.diameterMm - 2 * tube.radius(tube.along(place));
        errors.diameter = std::max(errors.diameter, std::abs(wrong) / grid.stepMm());
        errors.meanDiameter += wrong / grid.stepMm() / double(vessel.points.size());
        errors.axis += tube.off(place) / grid.stepMm() / double(vessel.points.size());
    }
    return errors;
}

// Measures between two voxels that lie off the axis.
inline Errors measuredAlong(const Straight& tube, const volume::GridGeometry& grid, const VoxelSet& set,
                            const volume::Volume* values = nullptr) {
    const auto across = glm::normalize(glm::cross(tube.direction, glm::dvec3(0.3, 1, 0.2)));
    const double off = 0.4 * tube.radius(0.6 * tube.half);
    const auto at = [&](double along, double side) {
        return voxelAt(grid, tube.middle + along * tube.direction + side * across);
    };
    const auto from = at(-0.6 * tube.half, off);
    const auto to = at(0.6 * tube.half, -off);
    const Vessel vessel = vesselBetween(set, grid, from, to, values);
    Errors errors = errorsOf(vessel, grid, tube);
    const double length = tube.along(worldAt(grid, to)) - tube.along(worldAt(grid, from));
    errors.length = std::abs(vessel.lengthMm - length) / grid.stepMm();
    return errors;
}
inline Errors measuredAlong(const Straight& tube, const volume::GridGeometry& grid) {
    return measuredAlong(tube, grid, setWhere(grid, tube));
}

} // namespace vs::segment

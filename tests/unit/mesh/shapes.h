// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "masks.h"

#include "mesh/segment_surface.h"
#include "segment/edits/label_sets.h"

#include <cmath>

namespace vs::mesh {

// The surface of label 1 of a grid, by a function of places in mm.
inline Mesh surfaceWhere(const volume::GridGeometry& grid, const std::function<int(glm::dvec3 world)>& label,
                         std::uint8_t of = 1) {
    const auto labels = segment::labelsWhere(grid, label);
    return segmentSurface(labels, grid, of, segment::labelBoxes(labels, grid.dims)[of]);
}

inline Mesh ball(double radius, glm::dvec3 spacing = glm::dvec3(1)) {
    return surfaceWhere(segment::centredGrid(2 * radius + 6, spacing),
                        [radius](glm::dvec3 p) { return glm::length(p) <= radius ? 1 : 0; });
}

// Around the z axis.
inline Mesh torus(double radius, double tube) {
    return surfaceWhere(segment::centredGrid(2 * (radius + tube) + 6, glm::dvec3(1)), [=](glm::dvec3 p) {
        return std::hypot(std::hypot(p.x, p.y) - radius, p.z) <= tube ? 1 : 0;
    });
}

} // namespace vs::mesh

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

namespace vs::render {

// Where a pasted part is drawn: turned and scaled about the grid's centre, then moved. World, LPS
// millimetres.
struct Placement {
    glm::dvec3 moveMm{0};
    glm::dvec3 turnDegrees{0}; // about the axis that it points along, by its length
    double scale = 1;

    bool operator==(const Placement&) const = default;
};

glm::dmat4 worldFromPart(const Placement& placement, const volume::GridGeometry& geometry);

// The rays of a view in the space that a part was cut out of: what is seen along them there is what a viewer
// sees of the part where it was placed. A length there is `placement.scale` times as long in the world.
ViewRays seenFromPart(const ViewRays& rays, const Placement& placement, const volume::GridGeometry& geometry);

} // namespace vs::render

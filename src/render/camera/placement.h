// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

namespace vs::render {

// Where a pasted part is drawn: turned and scaled about the grid's centre, then moved. World, LPS
// millimetres.
struct Placement {
    static constexpr const char* kName = "placement";

    glm::dvec3 moveMm{0};
    glm::dvec3 turnDegrees{0}; // about the axis that it points along, by its length
    double scale = 1;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{written("move", &Placement::moveMm, {.least = -1e6, .most = 1e6, .unit = "mm"},
                                  "towards the patient's left, back and head"),
                          written("turn", &Placement::turnDegrees,
                                  {.least = -360, .most = 360, .unit = "degrees"},
                                  "about the axis that it points along"),
                          written("scale", &Placement::scale, {.least = 0.01, .most = 100})};
    }

    bool operator==(const Placement&) const = default;
};

glm::dmat4 worldFromPart(const Placement& placement, const volume::GridGeometry& geometry);

// A placement as it is drawn when all parts are spread: the part's own middle (voxel space, where it was cut
// out) lies 1 + spread times as far from the grid's centre as where it was put. And the placement that is
// drawn so.
Placement spreadOut(const Placement& placement, double spread, glm::dvec3 middleVoxel,
                    const volume::GridGeometry& geometry);
Placement broughtTogether(const Placement& drawn, double spread, glm::dvec3 middleVoxel,
                          const volume::GridGeometry& geometry);

// The rays of a view in the space that a part was cut out of: what is seen along them there is what a viewer
// sees of the part where it was placed. A length there is `placement.scale` times as long in the world.
ViewRays seenFromPart(const ViewRays& rays, const Placement& placement, const volume::GridGeometry& geometry);

} // namespace vs::render

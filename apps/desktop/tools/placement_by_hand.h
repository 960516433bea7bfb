// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "render/camera/placement.h"

#include <QRectF>

namespace vs::desktop {

// A pasted part as it is held in the hand: about its own centre (world, where it was cut out) instead of the
// grid's.
class HeldPart {
public:
    HeldPart(const render::Placement& place, glm::dvec3 centre, const volume::GridGeometry& geometry)
        : place_(place), centre_(centre), geometry_(&geometry) {}

    [[nodiscard]] const render::Placement& place() const { return place_; }
    // The place where the part's centre is now.
    [[nodiscard]] glm::dvec3 centre() const;

    void move(glm::dvec3 mm) { place_.moveMm += mm; }
    // Turns the part about an axis of the world (unit length) through its centre.
    void turn(glm::dvec3 axis, double degrees);
    void scale(double factor);

private:
    void keepCentreAt(glm::dvec3 world);

    render::Placement place_;
    glm::dvec3 centre_;
    const volume::GridGeometry* geometry_;
};

// The box around a part (voxels, where it was cut out) as it is seen at a place, in pixels.
QRectF seenBox(const Box3& part, const render::Placement& place, const volume::GridGeometry& geometry,
               const render::ViewRays& rays);

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

namespace vs::render {

// The viewer's axes in the world, as columns: right, up and back (from what is seen to the viewer). Unit.
glm::dmat3 viewerAxes(const Camera& camera);

// The camera turned so that its viewer has these axes, which must be perpendicular, right-handed and unit:
// every way of looking has angles. Straight from above or below azimuth and roll mean the same turn, and the
// azimuth stays.
Camera withAxes(const Camera& camera, const glm::dmat3& axes);

// The camera turned freely, past the poles too, so that what it sees turns about an axis of the viewer
// (right, up, back) by the axis' length in degrees, anticlockwise as seen from the axis' tip.
Camera tumbled(const Camera& camera, glm::dvec3 degrees);

// The camera upright in front of a direction (world, any length but 0), as books show it: superior up, and
// anterior up where one looks from above or below.
Camera lookingFrom(const Camera& camera, glm::dvec3 direction);

// What becomes of `before` when it is turned as `turned` is, and then moved so that the viewer sees `pivot`
// (world) at the same place and at the same distance: the viewer goes around the pivot instead of the grid's
// centre. Where that would bring the viewer beyond the centre, `mostZoom` is as near as it gets.
Camera aroundPivot(const Camera& before, const Camera& turned, glm::dvec3 pivot,
                   const volume::GridGeometry& geometry, double mostZoom);

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

#include <span>

namespace vs::render {

// The camera that looks the same way and sees all of the points (world) as large as a picture of this size
// shows them, in its middle, with `margin` (a part of the picture's width and height, below a half) left free
// on each side. In perspective the viewer comes no nearer to the grid's centre than `mostZoom`, though points
// far behind it would be larger then. Without points the camera is as it was.
Camera fitted(const Camera& camera, const volume::GridGeometry& geometry, glm::ivec2 size,
              std::span<const glm::dvec3> points, double margin, double mostZoom);

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "render/camera/camera.h"
#include "studio/operations/drawn.h"

namespace vs::studio {

// Draws over a picture what the pen drew for an operation, in the tint of tools at rest or of cutting ones.
// `view` is what the picture shows, and also what was drawn on where the strokes name no canvas. Throws Error
// when they were drawn from elsewhere: flat lines would lie on other things than those that they were drawn
// on.
void markStrokes(image::Image& picture, const Drawn& drawn, bool isCutting, const View& view,
                 const volume::GridGeometry& geometry);

} // namespace vs::studio

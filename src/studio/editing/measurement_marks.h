// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "render/camera/camera.h"
#include "studio/state/measured.h"

#include <span>

namespace vs::studio {

// Draws measurements over a picture that was taken along these rays: lines from point to point, outlines of
// areas, and what they come to beside them, as large as the scale bar's text; of vessels the narrowest place
// and the curve of their diameters too. A measurement of which a point lies behind the viewer is left out;
// cuts have no place.
void markMeasurements(image::Image& picture, std::span<const Measured> measurements,
                      const render::ViewRays& rays, const volume::GridGeometry& geometry);

} // namespace vs::studio

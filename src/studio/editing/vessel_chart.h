// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "studio/state/measured.h"
#include "volume/grid/geometry.h"

#include <glm/glm.hpp>

namespace vs::studio {

// The diameters of a measured vessel along it as a curve, light on a dark card: what is healthy beside the
// narrowest place is dashed, and that place is marked with how much narrower it is. `scale` is as that of
// annotations (render/marks/annotation.h).
image::Image vesselChart(const Measured& vessel, const volume::GridGeometry& geometry, glm::ivec2 size,
                         double scale);

} // namespace vs::studio

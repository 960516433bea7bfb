// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/sweep_tool.h"

#include "studio/document/document.h"
#include "studio/document/surface_queries.h"

namespace vs::desktop {

// A sweep of a mask drawn on a canvas, straight or in a helix along the view's ray through the mask's centre
// (`start`: the surface there), for as many steps as set. The mask lies as it was drawn, in the plane across
// its way.
studio::Sweep sweepAlongView(const studio::Sketch& mask, const studio::Probe& start,
                             const SweepTool::Settings& settings, const studio::Canvas& canvas,
                             const volume::GridGeometry& geometry);

} // namespace vs::desktop

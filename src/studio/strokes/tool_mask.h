// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/rays/picker.h"
#include "sculpt/mask/mask.h"
#include "studio/operations/sketch.h"
#include "volume/grid/geometry.h"

#include <glm/glm.hpp>

#include <vector>

namespace vs::studio {

// Where a raster's elements are in the picture when its origin is at a pixel.
std::vector<glm::vec2> pixelsOf(const sculpt::MaskRaster& raster, glm::dvec2 centre);

// Where the volume appears, with as much around it as tools reach, in pixels. Without bounds where the viewer
// is among it.
sculpt::MaskWindow pictureOf(const volume::GridGeometry& geometry, const render::ViewRays& rays);

// How far apart two places can be, in mm, from which tools still reach the volume.
double acrossMm(const volume::GridGeometry& geometry);

// A sketch as a tool uses it: its mask, centred on the origin, in pixels. Of a sketch that is larger than the
// picture it is what can meet the volume from the places where tools are led to.
struct ToolMask {
    ToolMask(const Sketch& sketch, const render::Frame& frame, const volume::GridGeometry& geometry);

    sculpt::MaskRaster raster;
    glm::dvec2 drawnAt{0};     // the centre, where it was drawn
    glm::dvec2 extent{0};      // width and height
    sculpt::MaskWindow places; // to which it is led: in the picture, or beside it by the mask's size
};

} // namespace vs::studio

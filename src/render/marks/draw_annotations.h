// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "render/marks/annotation.h"
#include "render/marks/orientation_marker.h"

namespace vs::render {

// What lines and letters are drawn with: light ones on dark pictures, dark ones on light pictures. Both have
// a border of the other, so that they can be read on anything.
enum class Ink { Light, Dark };

// A small picture and where its first pixel lies in the whole one.
struct Annotation {
    image::Image image;
    glm::ivec2 corner{0};
};

Annotation drawScaleBar(const ScaleBar& bar, glm::ivec2 size, Ink ink, double density = 1);
Annotation drawOrientationMarker(const OrientationMarker& marker, glm::ivec2 size, Ink ink,
                                 double density = 1);

// The ink for a part of a picture, by its mean lightness. Transparent pixels count as paper.
Ink inkFor(const image::Image& picture, glm::ivec2 corner, glm::ivec2 size);

// Draws scale bar and orientation marker over a picture made with these rays. The rays' size is the
// picture's.
void annotate(image::Image& picture, const ViewRays& rays, const volume::GridGeometry& geometry);

} // namespace vs::render

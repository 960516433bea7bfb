// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

#include <string>

namespace vs::render {

// What is drawn over a picture to tell its scale: where things stand, in pixels of the picture (y down).
// render/marks/draw_annotations.h draws it, and the orientation marker (render/marks/orientation_marker.h).

// Factor on all sizes, which are given for a picture whose smaller side has 870 pixels: a picture looks the
// same at any size, except that in small ones text stays legible as long as there is room. `density`, here as
// below: so many pixels are as wide as one of an ordinary screen, on which text is as small as it may be.
double annotationScale(glm::ivec2 size, double density = 1);

// A bar whose length is a round number (1, 2 or 5 times a power of ten), the greatest that takes at most a
// quarter of the picture's width; so it takes at least a tenth. In perspective it measures at the depth of
// the volume's centre.
struct ScaleBar {
    double lengthMm = 0;
    std::string label;  // "5 cm"
    glm::dvec2 left{0}; // ends of its lower edge
    glm::dvec2 right{0};
};
ScaleBar scaleBar(const ViewRays& rays, const volume::GridGeometry& geometry, double density = 1);

// A length in the unit that makes its number handy: "200 nm", "50 µm", "2 mm", "5 cm", "1 m".
std::string lengthLabel(double mm);

} // namespace vs::render

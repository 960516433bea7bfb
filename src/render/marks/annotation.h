// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

#include <string>
#include <vector>

namespace vs::render {

// What is drawn over a picture to tell its scale and its direction: where things stand, in pixels of the
// picture (y down). render/marks/draw_annotations.h draws them.

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

// A letter of the orientation marker: R, L, A, P, S or I.
struct DirectionLetter {
    char letter = ' ';
    glm::dvec3 world{0};  // the direction it names, unit, LPS
    glm::dvec2 place{0};  // its centre
    double size = 0;      // of the em
    glm::dmat2 axes{1.0}; // where its reading and its downward direction go: it lies on its face
    bool isOnFace = false;
    double opacity =
        1; // below 1 only for a moment of turning, when it changes from beside the cube to its face
};

// A flat piece of the cube's surface that faces the viewer.
struct CubeFacet {
    std::vector<glm::dvec2> corners;
    glm::dvec3 normal{0}; // in the viewer's axes: right, up, towards the viewer
};

// A cube with bevelled edges that turns with the camera, seen without perspective. Each face that is turned
// to the viewer carries the letter of its direction, upright; directions that lie (nearly) in the picture
// have theirs beside the cube, so that a straight view says right and left too; directions pointing away show
// nothing.
struct OrientationMarker {
    glm::dvec2 centre{0};
    double radius = 0; // everything lies within
    std::vector<CubeFacet> facets;
    std::vector<DirectionLetter> letters;
};
OrientationMarker orientationMarker(const ViewRays& rays, double density = 1);

} // namespace vs::render

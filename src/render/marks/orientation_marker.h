// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

#include <optional>
#include <vector>

namespace vs::render {

// What is drawn over a picture to tell which way it looks: where things stand, in pixels of the picture (y
// down). render/marks/draw_annotations.h draws it; `density` as for annotationScale().

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
    double radius = 0;   // everything lies within
    double halfEdge = 0; // of the cube
    std::vector<CubeFacet> facets;
    std::vector<std::vector<glm::dvec2>> lit; // what of the facets is pointed at
    std::vector<DirectionLetter> letters;
};
// `pointedAt`: the zone (see zoneAt()) that is shown to be pointed at; nothing: none.
OrientationMarker orientationMarker(const ViewRays& rays, double density = 1,
                                    const std::optional<glm::dvec3>& pointedAt = {});

// The cube has 26 zones to look from: its faces, its edges and its corners. The one that is seen at a pixel,
// as the direction (world, of length 1) from which it is looked at straight; nothing beside the cube.
std::optional<glm::dvec3> zoneAt(const ViewRays& rays, glm::dvec2 pixel, double density = 1);

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/wall_edges.h"

namespace vs::segment {

// How a vessel is cut by a plane across its axis.
struct CrossSection {
    double diameterMm = 0;      // of the circle with the area
    double leastDiameterMm = 0; // the narrowest way through the middle
    glm::dvec2 middleMm{0};     // from the axis to the middle of the area, along the plane's axes
};

// The cross-sections at the stations of a centreline.
//
// Around each station the wall is a function of angle and length, radius = c0 + c1 s + c2 s^2 + the first few
// harmonics of the angle. It is the likeliest wall that parts the voxels inside from those outside (logistic
// regression, their weight falling as a Gaussian's along the axis), between two that part them equally well
// the rounder one. Counting voxels, or where a smoothed mask passes a half, would find the mean wall too;
// but of a vessel along the grid, or of one that is only a few slices thick, all sections are wrong in the
// same way, and what a circle of the wrong size would leave on the wrong side is what tells its size.
// With `edges` the scan's values tell the wall where they can, which is exacter (wallsAlong()).
std::vector<CrossSection> crossSections(const Lumen& lumen, const Centreline& line, const ScanEdges* edges);

// Moves the centreline into the middles of its cross-sections, by which it becomes exact to a fraction of a
// voxel. Twice without the scan's values and, where there are any, once with them leaves nothing to be moved
// by a tenth of a voxel.
void refine(const Lumen& lumen, Centreline& line, const ScanEdges* edges);

} // namespace vs::segment

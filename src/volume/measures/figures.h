// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <glm/glm.hpp>

#include <limits>
#include <span>

namespace vs::volume {

// What is measured along and inside figures that are drawn in a scan. Lengths in mm; places of the world are
// in LPS mm.

// From the first place to the last, along the lines between them.
double lengthMm(std::span<const glm::dvec3> world);

// At the second of three places, 0 to 180; 0 where one of the legs has no length.
double angleDegrees(glm::dvec3 world, glm::dvec3 corner, glm::dvec3 other);

// What lies inside a closed outline on a slice.
struct UnderOutline {
    double mm2 = 0;         // of the outline itself, whose area is that of a polygon
    std::size_t voxels = 0; // of the slice whose centres it encloses, and that have a finite value
    double mean = std::numeric_limits<double>::quiet_NaN();      // of their values, as the next three
    double deviation = std::numeric_limits<double>::quiet_NaN(); // of these voxels, not of what they sample
    double smallest = std::numeric_limits<double>::quiet_NaN();
    double largest = std::numeric_limits<double>::quiet_NaN();
};

// The axis of the grid along which all points of an outline (voxel space) have the same place, to a hundredth
// of a voxel; -1 where there is none, and the outline lies in no slice.
int sliceAxis(std::span<const glm::dvec3> outline);

// `outline` as for sliceAxis(), at least three points. A voxel is enclosed by the even-odd rule. The slice is
// the nearest one.
UnderOutline underOutline(const Volume& volume, std::span<const glm::dvec3> outline);

} // namespace vs::volume

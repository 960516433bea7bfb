// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/curve.h"
#include "segment/measures/lumen.h"
#include "segment/measures/vessel_path.h"

namespace vs::segment {

// The axis of a vessel, about half a voxel exact, and a stretch beyond both ends of what is to be measured
// where the vessel goes on, so that what is looked at around the ends is there.
struct Centreline {
    Curve curve;
    std::vector<double> radiiMm; // about, at each station
};

// The axis along a path through the lumen. Where the path leads from a wall to the middle its ends are left
// out, and the axis goes on from the middle until its plane has passed the path's end.
Centreline centrelineAlong(const Lumen& lumen, const VesselPath& path);

// How far apart the stations of a vessel of some radius are.
double spacingMm(const Lumen& lumen, double radiusMm);

// How far along the curve places count when it is smoothed: about half a radius, and more than a voxel.
double smoothingMm(const Lumen& lumen, const std::vector<double>& radiiMm);

} // namespace vs::segment

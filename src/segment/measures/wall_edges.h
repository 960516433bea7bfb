// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/centreline.h"
#include "segment/measures/wall_fit.h"
#include "segment/measures/wall_values.h"

#include <optional>

namespace vs::segment {

// A scan whose values are edges where the vessel's wall is.
struct ScanEdges {
    ScanValues values;
    Sight sight = {};
    double noise = 0; // how wrong single values are, standard deviation in parts of the contrast
};

// Tells how blurred the scan's edges are and how thick its slices, by what lets a wall explain the values
// best along the vessel. Nothing where the mask itself explains them better than any wall: its values have no
// more to say.
std::optional<ScanEdges> scanEdgesAlong(const ScanValues& values, const Lumen& lumen, const Centreline& line);

// The walls at the stations of a centreline. With `edges` they lie where the scan's values pass half of what
// they change by from the inside to the outside. In directions where that is farther than about half a voxel
// from the mask's wall, or where there is no clear edge, and at stations where most directions are so, the
// mask tells the wall.
std::vector<WallShape> wallsAlong(const Lumen& lumen, const Centreline& line, const ScanEdges* edges);

} // namespace vs::segment

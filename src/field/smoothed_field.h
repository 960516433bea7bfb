// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"

namespace vs::field {

// A volume's values convolved with a Gaussian, for surfaces that are to be smoother than the data: a skin at
// a low threshold shows a scan's noise as wood grain. The Gaussian is as wide in mm along all axes and ends
// at three sigma; at the grid's border the outermost values go on. Non-finite voxels stay what they are and
// count for nothing in what is around them.
struct SmoothedField {
    // Values in the source's unit and on its grid; whole numbers become 16-bit texels over the source's
    // range, fine enough that no steps show.
    Field field;
    CellRanges cells; // of those values
    double sigmaSteps = 0;
};

// Smooths by `sigmaSteps` > 0 smallest spacings, at most kMostSigmaSteps. Throws GlError if the device has no
// room: the field once more (16 bits a voxel for whole numbers, else 32), and scratch for some slices.
inline constexpr double kMostSigmaSteps = 2;
SmoothedField smoothField(const Field& source, double sigmaSteps);

} // namespace vs::field

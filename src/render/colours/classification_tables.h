// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/colours/transfer_function.h"

namespace vs::render {

// Texels along a curve and along the two sides of a plane: so many that they need no interpolation. Of a
// plane's the function is asked for every second one, and those between are their means.
inline constexpr int kCurveTexels = 4089;
inline constexpr glm::ivec2 kPlaneTexels{1023, 511};
inline constexpr int kPlanePitch = 2;

// One transfer function as tables. Texel i of n along an axis holds the function at axis.lo + i / (n - 1) *
// width; values outside belong to the nearest texel.
struct ClassificationTables {
    glm::ivec2 size{1};
    Range values;                // what the main table spans across (Intensity, TwoD)
    Range gradients;             // Gradient: across; TwoD: upwards
    std::vector<glm::vec4> main; // linear colour, opacity per step; not premultiplied

    // Intensity only: what a piece of a ray shows along which the value goes evenly over a span of columns
    // (pre-integrated classification, Engel, Kraus and Ertl 2001, "High-quality pre-integrated volume
    // rendering using hardware-accelerated pixel shading", by middle and width instead of both ends, and
    // without what the piece hides of itself). Row 4 k + m is for spans of (1 + m / 4) 2^k columns; its
    // texels stand 2^(k - 3) columns apart, 1 at the least, and hold means over spans narrower by that less
    // one, so that rounding to the nearest texel looks at nothing outside. xyz colour, each weighted by its
    // optical depth; w opacity over half a step. Empty for the other kinds.
    std::vector<glm::vec4> spans;

    // What of the main table has any opacity, by columns of values and rows of gradient magnitudes: entry
    // (i, j) counts it in the columns before i and the rows before j, so there is one more of each. For the
    // Gradient kind, whose values tell nothing, a single column stands for all, for Intensity a single row.
    glm::ivec2 visibleSize{1};
    std::vector<std::uint32_t> visibleBefore;
};

// Rows of spans, four widths an octave, from one column to more than all of them; and texels before and after
// those that stand for columns.
inline constexpr int kSpanRows = 49;
inline constexpr int kSpanMargin = 8;

// Makes the tables of a function whose positions are absolute; `dataValues` are the values that there are at
// all.
ClassificationTables makeTables(const TransferFunction& absolute, const Range& dataValues, double stepMm);

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/transfer_function.h"

namespace vs::render {

// So many along a curve that it needs no interpolation, and over a plane.
inline constexpr int kCurveTexels = 4089;
inline constexpr glm::ivec2 kPlaneTexels{512, 256};

// One transfer function as tables. Texel i of n along an axis holds the function at axis.lo + i / (n - 1) *
// width; values outside belong to the nearest texel.
struct ClassificationTables {
    glm::ivec2 size{1};
    Range values;                // what the main table spans across (Intensity, TwoD)
    Range gradients;             // Gradient: across; TwoD: upwards
    std::vector<glm::vec4> main; // linear colour, opacity per step; not premultiplied

    // How many texel columns up to and with i - 1 have any opacity; one more than there are columns. For the
    // Gradient kind, whose values tell nothing, a single column stands for all.
    std::vector<std::uint32_t> visibleBefore;
};

// `dataValues` are the values that there are at all. Positions must be absolute.
ClassificationTables makeTables(const TransferFunction& absolute, const Range& dataValues, double stepMm);

} // namespace vs::render

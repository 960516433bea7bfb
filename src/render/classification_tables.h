// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/transfer_function.h"

namespace vs::render {

// Texels of the pre-integrated table along each axis, and how many finer parts lie between two of them. The
// main table has one texel for each of these parts, so segments are summed up without interpolation.
inline constexpr int kSegmentTexels = 512;
inline constexpr int kPartsPerSegmentTexel = 8;
inline constexpr int kCurveTexels = kPartsPerSegmentTexel * (kSegmentTexels - 1) + 1;
inline constexpr glm::ivec2 kPlaneTexels{512, 256};

// One transfer function as tables. Texel i of n along an axis holds the function at axis.lo + i / (n - 1) *
// width; values outside belong to the nearest texel.
struct ClassificationTables {
    glm::ivec2 size{1};
    Range values;                // what the main table spans across (Intensity, TwoD)
    Range gradients;             // Gradient: across; TwoD: upwards
    std::vector<glm::vec4> main; // linear colour, opacity per step; not premultiplied

    // Integrals of main from texel 0 to i, a texel being the unit of length, for the Intensity kind: xyz
    // extinction times colour, w extinction, in fixed point (`quantum` is what one unit means), so that
    // differences do not lose what is small.
    std::vector<glm::uvec4> integrals;
    double quantum = 1;

    // How many texel columns up to and with i - 1 have any opacity; one more than there are columns. For the
    // Gradient kind, whose values tell nothing, a single column stands for all.
    std::vector<std::uint32_t> visibleBefore;
};

// `dataValues` are the values that there are at all. Positions must be absolute.
ClassificationTables makeTables(const TransferFunction& absolute, const Range& dataValues, double stepMm);

// Extinction per step; fully opaque is held to what single precision can tell from it.
double extinction(double opacityPerStep);

} // namespace vs::render

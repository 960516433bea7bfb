// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace vs::sculpt {

// A height over a plane in square cells of one unit, x fastest, as far as it is known.
struct PlateRaster {
    glm::ivec2 size{0};
    std::vector<double> heights;
    std::vector<double> weights; // how much what is known of a cell counts; 0: nothing is known
};

// The height in all cells that bends least: of all surfaces the one with the least sum of squared second
// derivatives (h_xx^2 + 2 h_xy^2 + h_yy^2) and of weight * (h - height)^2, which is a thin plate (Duchon
// 1977). Where nothing is known it goes on as what is beside it, with its slope; beyond the raster it is
// free. The smaller the weights, the more noise is smoothed away: over weight^(-1/4) cells. Throws Error
// where too little is known: fewer than three cells, or all of them in a line.
std::vector<double> thinPlate(const PlateRaster& known);

} // namespace vs::sculpt

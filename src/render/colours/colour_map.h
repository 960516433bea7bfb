// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/colours/colour.h"

#include <span>
#include <string_view>
#include <vector>

namespace vs::render {

// A row of colours that reads as a scale: equal parts of it differ by equal distances in OKLab, and lightness
// rises all the way (in a diverging one up to the middle, then falls), so that colour-blind eyes and grey
// prints order it too.
struct ColourMap {
    std::string_view name;
    std::string_view description;
    bool isDiverging = false;
    std::vector<glm::dvec3> oklab; // evenly spread from 0 to 1

    // OKLab colour at a place from 0 to 1; what lies outside takes the nearest end.
    [[nodiscard]] glm::dvec3 at(double place) const;
};

// All maps, made when first asked for.
std::span<const ColourMap> colourMaps();
// The map of a name; null if there is none.
const ColourMap* findColourMap(std::string_view name);
// The names of all maps, in that order.
std::span<const char* const> colourMapNames();

} // namespace vs::render

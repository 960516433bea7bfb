// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "image/image.h"

#include <optional>
#include <string>
#include <vector>

namespace vs::image {

// One axis of a chart: what it runs over, divided equally among its bins, and what it is called.
struct ChartAxis {
    Range range;
    std::string label;
};

// Counts along one axis, for print: dark on white paper.
struct BarChart {
    std::string title; // at the left above the plot; shortened to what fits
    std::string note;  // at its right
    ChartAxis across;
    std::string countLabel = "voxels";
    std::vector<double> counts;
    bool isLogarithmic = true; // the counts' axis; counts of zero have no bar there
    std::optional<Range> shaded;
    std::string shadedLabel; // above it: "displayed range 50 to 254"
};

// Counts over two axes, as colours from dark (none) to light, with the scale of colours beside them. The
// scale ends in a point where a few counts go beyond it; they have its lightest colour.
struct DensityChart {
    std::string title;
    std::string note;
    ChartAxis across;
    ChartAxis up;
    std::string countLabel = "voxels";
    glm::ivec2 bins{0};
    std::vector<double> counts; // bins.x * bins.y, along `across` first
    bool isLogarithmic = true;
    std::vector<glm::u8vec3> colours; // display colours, evenly spread from no voxels to the most
    std::optional<Range> marked;      // of `across`
    std::string markedLabel;          // above it
};

// Charts smaller than this have no room for their axes.
inline constexpr glm::ivec2 kSmallestChart{240, 180};

Image drawChart(const BarChart& chart, glm::ivec2 size);
Image drawChart(const DensityChart& chart, glm::ivec2 size);

} // namespace vs::image

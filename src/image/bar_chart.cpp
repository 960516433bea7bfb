// SPDX-License-Identifier: Apache-2.0
#include "image/chart.h"

#include "base/check.h"
#include "image/chart_parts.h"

#include <algorithm>
#include <cmath>

namespace vs::image {

namespace {

// From a count to a part of the axis. A logarithmic one begins at a half, so that a single voxel shows.
struct CountScale {
    double greatest;
    bool isLogarithmic;

    [[nodiscard]] double part(double count) const {
        if (!isLogarithmic) {
            return count / (1.05 * greatest);
        }
        return count <= 0.5 ? 0 : std::log(count / 0.5) / std::log(1.6 * greatest / 0.5);
    }
};

Outline barsOf(const BarChart& chart, const Layout& layout, const CountScale& scale) {
    Outline outline{layout.at({0, 0})};
    const double n = double(chart.counts.size());
    for (std::size_t i = 0; i < chart.counts.size(); ++i) {
        const double height = scale.part(chart.counts[i]);
        outline.push_back(layout.at({double(i) / n, height}));
        outline.push_back(layout.at({double(i + 1) / n, height}));
    }
    outline.push_back(layout.at({1, 0}));
    return outline;
}

void drawBars(Drawing& drawing, const BarChart& chart, const Layout& layout, const CountScale& scale,
              const std::vector<Tick>& ticks) {
    const double hair = layout.hairline();
    const auto shaded = partsOf(chart.shaded, chart.across.range);
    const glm::dvec2 lo = shaded ? layout.at({shaded->lo, 1}) : layout.lo;
    const glm::dvec2 hi = shaded ? layout.at({shaded->hi, 0}) : layout.lo;
    if (shaded) {
        drawing.fillBox(lo, hi, kShade);
    }
    for (const auto& tick : ticks) {
        const double y = std::round(layout.at({0, tick.part}).y - 0.5 * hair);
        drawing.fillBox({layout.lo.x, y}, {layout.hi.x, y + hair}, kGrid);
    }
    const Outline bars = barsOf(chart, layout, scale);
    drawing.fill(bars, shaded ? kQuietBar : kBar);
    if (!shaded) {
        return;
    }
    drawing.showOnly(lo, hi);
    drawing.fill(bars, kBar);
    drawing.showAll();
    for (const double x : {std::round(lo.x), std::round(hi.x) - hair}) {
        drawing.fillBox({x, layout.lo.y}, {x + hair, layout.hi.y}, kShadeEdge);
    }
    drawRangeLabel(drawing, layout, *shaded, chart.shadedLabel);
}

} // namespace

Image drawChart(const BarChart& chart, glm::ivec2 size) {
    VS_CHECK(!chart.counts.empty() && chart.across.range.width() > 0);
    Layout layout(size);
    const CountScale scale{std::max(1.0, *std::max_element(chart.counts.begin(), chart.counts.end())),
                           chart.isLogarithmic};
    const auto part = [&](double count) { return scale.part(count); };
    // The plot's height decides on the ticks, their width on its own: nearly all of the picture's height is
    // close.
    const auto up = countTicks(scale.greatest, scale.isLogarithmic, 0.8 * size.y, 60 * layout.scale, part);
    placePlot(layout, size, widest(up, layout.tickSize), 0, layout.labelRow(chart.shaded.has_value()));
    const auto across = linearTicks(chart.across.range, layout.plotSize().x, 95 * layout.scale);

    Drawing drawing(size);
    drawBars(drawing, chart, layout, scale, up);
    drawAcross(drawing, layout, across, chart.across.label);
    drawUp(drawing, layout, up, chart.countLabel);
    drawHeading(drawing, layout, chart.title, chart.note, layout.hi.x);
    return onPaper(drawing, paper(size));
}

} // namespace vs::image

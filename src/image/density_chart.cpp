// SPDX-License-Identifier: Apache-2.0
#include "image/chart.h"

#include "base/check.h"
#include "image/chart_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vs::image {

namespace {

// Of how much of the scale of colours a count takes.
struct DensityScale {
    double greatest; // takes all of it, and so does more
    bool isLogarithmic;

    [[nodiscard]] double part(double count) const {
        return std::min(1.0, isLogarithmic ? std::log1p(count) / std::log1p(greatest) : count / greatest);
    }
};

// The count that only one in a thousand of the cells with any exceeds: a single cell, of the air around a
// head, would leave all others dark.
double commonGreatest(const std::vector<double>& counts) {
    std::vector<double> some;
    std::copy_if(counts.begin(), counts.end(), std::back_inserter(some),
                 [](double count) { return count > 0; });
    if (some.empty()) {
        return 1;
    }
    const auto place = some.begin() + std::ptrdiff_t(0.999 * double(some.size() - 1));
    std::nth_element(some.begin(), place, some.end());
    return *place;
}

// Mean over the cells that a pixel covers: x from `from` to `to` and likewise y, in cells.
double meanPart(const DensityChart& chart, const std::vector<double>& parts, glm::dvec2 from, glm::dvec2 to) {
    double sum = 0;
    for (int y = int(from.y); y < std::min(int(std::ceil(to.y)), chart.bins.y); ++y) {
        const double tall = std::min(to.y, y + 1.0) - std::max(from.y, double(y));
        for (int x = int(from.x); x < std::min(int(std::ceil(to.x)), chart.bins.x); ++x) {
            const double wide = std::min(to.x, x + 1.0) - std::max(from.x, double(x));
            sum += tall * wide * parts[std::size_t(y) * std::size_t(chart.bins.x) + std::size_t(x)];
        }
    }
    return sum / ((to.x - from.x) * (to.y - from.y));
}

void putColour(Image& image, int x, int y, const std::vector<glm::u8vec3>& colours, double part) {
    const auto last = double(colours.size() - 1);
    const glm::u8vec3 colour = colours[std::size_t(std::lround(std::clamp(part, 0.0, 1.0) * last))];
    std::copy_n(&colour.x, 3, image.pixel(x, y));
}

void putCells(Image& image, const DensityChart& chart, const Layout& layout, const DensityScale& scale) {
    std::vector<double> parts(chart.counts.size());
    std::transform(chart.counts.begin(), chart.counts.end(), parts.begin(),
                   [&](double count) { return scale.part(count); });
    const glm::ivec2 lo(layout.lo);
    const glm::ivec2 hi(layout.hi);
    const glm::dvec2 cells = glm::dvec2(chart.bins) / layout.plotSize();
    for (int y = lo.y; y < hi.y; ++y) {
        for (int x = lo.x; x < hi.x; ++x) {
            const glm::dvec2 from = glm::dvec2(x - lo.x, hi.y - 1 - y) * cells;
            putColour(image, x, y, chart.colours, meanPart(chart, parts, from, from + cells));
        }
    }
}

void putColourBar(Image& image, const std::vector<glm::u8vec3>& colours, glm::ivec2 lo, glm::ivec2 hi) {
    for (int y = lo.y; y < hi.y; ++y) {
        for (int x = lo.x; x < hi.x; ++x) {
            putColour(image, x, y, colours, (hi.y - y - 0.5) / (hi.y - lo.y));
        }
    }
}

// Its ticks and its name at its right, the name above.
void labelColourBar(Drawing& drawing, const Layout& layout, double right, const std::vector<Tick>& ticks,
                    const std::string& label) {
    const double hair = layout.hairline();
    for (const auto& tick : ticks) {
        const double y = std::round(layout.at({0, tick.part}).y - 0.5 * hair);
        drawing.fillBox({right, y}, {right + 6 * layout.scale, y + hair}, kText);
        drawing.text(centredOn(tick.label, {right + layout.gap() + 2 * layout.scale, y + 0.5 * hair},
                               layout.tickSize, Align::Left),
                     kText);
    }
    drawing.text({label, {right + 2 * layout.scale, layout.lo.y - 0.7 * layout.gap()}, layout.tickSize},
                 kQuiet);
}

// Ends the bar in a point: some counts are beyond it.
void pointUpward(Drawing& drawing, glm::dvec2 left, glm::dvec2 right, glm::u8vec3 colour) {
    const glm::dvec3 c = glm::dvec3(colour) / 255.0;
    const glm::dvec2 tip = 0.5 * (left + right) - glm::dvec2(0, 0.5 * (right.x - left.x));
    drawing.fill({left, tip, right}, {c.x, c.y, c.z});
}

void drawMarks(Drawing& drawing, const Layout& layout, const Range& parts) {
    const double hair = layout.hairline();
    for (const double part : {parts.lo, parts.hi}) {
        const double x =
            std::clamp(std::round(layout.at({part, 0}).x - 0.5 * hair), layout.lo.x, layout.hi.x - hair);
        drawing.fillBox({x, layout.lo.y}, {x + hair, layout.hi.y}, {1, 1, 1, 0.75});
    }
}

} // namespace

Image drawChart(const DensityChart& chart, glm::ivec2 size) {
    VS_CHECK(!chart.colours.empty() &&
             chart.counts.size() == std::size_t(chart.bins.x) * std::size_t(chart.bins.y) &&
             chart.across.range.width() > 0 && chart.up.range.width() > 0);
    Layout layout(size);
    const DensityScale scale{commonGreatest(chart.counts), chart.isLogarithmic};
    const auto part = [&](double count) { return scale.part(count); };
    const auto up = linearTicks(chart.up.range, 0.8 * size.y, 60 * layout.scale);
    const auto counts =
        countTicks(scale.greatest, scale.isLogarithmic, 0.8 * size.y, 60 * layout.scale, part);
    const double barWidth = std::round(24 * layout.scale);
    const double besideBar = std::max(widest(counts, layout.tickSize) + layout.gap(),
                                      textWidth(chart.countLabel, layout.tickSize)) +
                             2 * layout.scale;
    placePlot(layout, size, widest(up, layout.tickSize), barWidth + besideBar + 2.5 * layout.gap(),
              layout.labelRow(true));
    const auto across = linearTicks(chart.across.range, layout.plotSize().x, 95 * layout.scale);
    const double barLeft = std::round(layout.hi.x + 2.5 * layout.gap());

    Image image = paper(size);
    putCells(image, chart, layout, scale);
    putColourBar(image, chart.colours, glm::ivec2(glm::dvec2(barLeft, layout.lo.y)),
                 glm::ivec2(glm::dvec2(barLeft + barWidth, layout.hi.y)));
    Drawing drawing(size);
    if (const auto marked = partsOf(chart.marked, chart.across.range)) {
        drawMarks(drawing, layout, *marked);
        drawRangeLabel(drawing, layout, *marked, chart.markedLabel);
    }
    drawAcross(drawing, layout, across, chart.across.label);
    drawUp(drawing, layout, up, chart.up.label);
    if (*std::max_element(chart.counts.begin(), chart.counts.end()) > scale.greatest) {
        pointUpward(drawing, {barLeft, layout.lo.y}, {barLeft + barWidth, layout.lo.y}, chart.colours.back());
    }
    labelColourBar(drawing, layout, barLeft + barWidth, counts, chart.countLabel);
    drawHeading(drawing, layout, chart.title, chart.note, size.x - layout.margin());
    return onPaper(drawing, std::move(image));
}

} // namespace vs::image

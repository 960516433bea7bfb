// SPDX-License-Identifier: Apache-2.0
#include "image/chart.h"

#include "base/check.h"
#include "image/axis.h"
#include "image/colour_scale.h"
#include "image/drawing.h"

#include <algorithm>
#include <cmath>

namespace vs::image {

namespace {

constexpr Colour kPaper{1, 1, 1};
constexpr Colour kText{0.10, 0.11, 0.13};
constexpr Colour kQuiet{0.36, 0.39, 0.43};
constexpr Colour kGrid{0.90, 0.91, 0.92};
constexpr Colour kBar{0.62, 0.66, 0.70};
constexpr Colour kShadedBar{0.00, 0.36, 0.58}; // the Okabe-Ito palette's blue, darker
constexpr Colour kShade{0.91, 0.955, 0.985};
constexpr Colour kShadeEdge{0.25, 0.55, 0.75};

struct Tick {
    double part; // along the axis, 0..1
    std::string label;
};

// Where everything stands. Sizes are for a chart of 1200 x 800 pixels; in small ones text stays legible.
struct Layout {
    double scale;
    double tickSize;  // of the em
    double labelSize; // of axis labels
    double titleSize;
    glm::dvec2 lo{0}; // the plot's corners, on pixel borders
    glm::dvec2 hi{0};

    Layout(glm::ivec2 size)
        : scale(std::max(std::min(size.x / 1200.0, size.y / 800.0), 0.55)), tickSize(17 * scale),
          labelSize(19 * scale), titleSize(20 * scale) {}

    [[nodiscard]] glm::dvec2 plotSize() const { return hi - lo; }
    [[nodiscard]] glm::dvec2 at(glm::dvec2 part) const {
        return {lo.x + part.x * (hi.x - lo.x), hi.y - part.y * (hi.y - lo.y)};
    }
    [[nodiscard]] double hairline() const { return std::max(1.0, std::round(scale)); }
    // Between the edge of the picture and anything, and between two things.
    [[nodiscard]] double margin() const { return 20 * scale; }
    [[nodiscard]] double gap() const { return 9 * scale; }
};

double widest(const std::vector<Tick>& ticks, double size) {
    double width = 0;
    for (const auto& tick : ticks) {
        width = std::max(width, textWidth(tick.label, size));
    }
    return width;
}

std::vector<Tick> linearTicks(const Range& range, double pixels, double perTick) {
    std::vector<Tick> ticks;
    for (const double value : roundTicks(range, std::clamp(int(pixels / perTick), 2, 12))) {
        ticks.push_back({(value - range.lo) / range.width(), tickLabel(value)});
    }
    return ticks;
}

// Of counts, by a function from counts to parts of the axis.
template <typename F>
std::vector<Tick> countTicks(double greatest, bool isLogarithmic, double pixels, double perTick, F part) {
    const int most = std::clamp(int(pixels / perTick), 2, 10);
    std::vector<Tick> ticks;
    if (isLogarithmic) {
        for (const double value : decadeTicks({1, std::max(greatest, 1.0)}, most)) {
            ticks.push_back({part(value), decadeLabel(value)});
        }
    } else {
        for (const double value : roundTicks({0, std::max(greatest, 1.0)}, most)) {
            ticks.push_back({part(value), tickLabel(value)});
        }
    }
    return ticks;
}

// Text on a baseline so that capitals are centred on a height.
Text centredOn(const std::string& text, glm::dvec2 middle, double size, Align align) {
    return {text, {middle.x, middle.y + 0.5 * kCapHeight * size}, size, align};
}

// A text without its middle, as long as fits.
std::string shortened(const std::string& text, double size, bool isBold, double width) {
    if (textWidth(text, size, isBold) <= width) {
        return text;
    }
    for (std::size_t keep = text.size(); keep > 2; --keep) {
        std::size_t head = keep / 2;
        std::size_t tail = text.size() - (keep - head);
        // Never through a character of several bytes.
        while (head > 0 && (std::uint8_t(text[head]) & 0xC0U) == 0x80U) {
            --head;
        }
        while (tail < text.size() && (std::uint8_t(text[tail]) & 0xC0U) == 0x80U) {
            ++tail;
        }
        const std::string tried = text.substr(0, head) + "…" + text.substr(tail);
        if (textWidth(tried, size, isBold) <= width) {
            return tried;
        }
    }
    return "";
}

void drawHeading(Drawing& drawing, const Layout& layout, const std::string& title, const std::string& note,
                 double right) {
    const double y = layout.margin() + kCapHeight * layout.titleSize;
    const double noteWidth = textWidth(note, layout.tickSize);
    const double room = right - layout.lo.x - noteWidth - 2 * layout.margin();
    drawing.text({shortened(title, layout.titleSize, true, room),
                  {layout.lo.x, y},
                  layout.titleSize,
                  Align::Left,
                  true},
                 kText);
    drawing.text({note, {right, y}, layout.tickSize, Align::Right}, kQuiet);
}

void drawAcross(Drawing& drawing, const Layout& layout, const std::vector<Tick>& ticks,
                const std::string& label) {
    const double hair = layout.hairline();
    drawing.fillBox({layout.lo.x - hair, layout.hi.y}, {layout.hi.x, layout.hi.y + hair}, kText);
    for (const auto& tick : ticks) {
        const double x = std::round(layout.at({tick.part, 0}).x - 0.5 * hair);
        drawing.fillBox({x, layout.hi.y}, {x + hair, layout.hi.y + 7 * layout.scale}, kText);
        drawing.text(
            {tick.label,
             {x + 0.5 * hair, layout.hi.y + layout.gap() + 3 * layout.scale + kCapHeight * layout.tickSize},
             layout.tickSize,
             Align::Centre},
            kText);
    }
    const double baseline =
        layout.hi.y + 2 * layout.gap() + 6 * layout.scale + kCapHeight * (layout.tickSize + layout.labelSize);
    drawing.text({label, {0.5 * (layout.lo.x + layout.hi.x), baseline}, layout.labelSize, Align::Centre},
                 kText);
}

void drawUp(Drawing& drawing, const Layout& layout, const std::vector<Tick>& ticks,
            const std::string& label) {
    const double hair = layout.hairline();
    drawing.fillBox({layout.lo.x - hair, layout.lo.y}, {layout.lo.x, layout.hi.y + hair}, kText);
    for (const auto& tick : ticks) {
        const double y = std::round(layout.at({0, tick.part}).y - 0.5 * hair);
        drawing.fillBox({layout.lo.x - 7 * layout.scale, y}, {layout.lo.x, y + hair}, kText);
        drawing.text(centredOn(tick.label, {layout.lo.x - layout.gap() - 3 * layout.scale, y + 0.5 * hair},
                               layout.tickSize, Align::Right),
                     kText);
    }
    Text upward{label,
                {layout.margin() + kCapHeight * layout.labelSize, 0.5 * (layout.lo.y + layout.hi.y)},
                layout.labelSize,
                Align::Centre};
    upward.axes = glm::dmat2(glm::dvec2(0, -1), glm::dvec2(1, 0));
    drawing.text(upward, kText);
}

// The margins around the plot. Its left one has room for the widest label of the axis upward.
void placePlot(Layout& layout, glm::ivec2 size, double upLabels, double extraRight, double extraTop) {
    const double tickRoom = layout.gap() + 3 * layout.scale;
    layout.lo = {layout.margin() + kCapHeight * layout.labelSize + 1.4 * layout.gap() + upLabels + tickRoom,
                 layout.margin() + kCapHeight * layout.titleSize + 1.6 * layout.gap() + extraTop};
    layout.hi = {size.x - layout.margin() - extraRight,
                 size.y - layout.margin() - 2 * layout.gap() - 9 * layout.scale -
                     kCapHeight * (layout.tickSize + layout.labelSize)};
    layout.lo = glm::round(layout.lo);
    layout.hi = glm::round(layout.hi);
}

Image paper(glm::ivec2 size) {
    Image image(size.x, size.y);
    std::fill(image.rgba.begin(), image.rgba.end(), std::uint8_t(255));
    return image;
}

Image onPaper(const Drawing& drawing, Image image) {
    blend(image, drawing.picture());
    return image;
}

// --- bars

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

// The shaded part of the axis across, within the plot; nothing if it lies outside.
std::optional<Range> partsOf(const std::optional<Range>& shaded, const Range& across) {
    if (!shaded || shaded->hi < across.lo || shaded->lo > across.hi) {
        return std::nullopt;
    }
    const auto part = [&](double value) {
        return std::clamp((value - across.lo) / across.width(), 0.0, 1.0);
    };
    return Range{part(shaded->lo), part(shaded->hi)};
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
    drawing.fill(bars, kBar);
    if (!shaded) {
        return;
    }
    drawing.showOnly(lo, hi);
    drawing.fill(bars, kShadedBar);
    drawing.showAll();
    for (const double x : {std::round(lo.x), std::round(hi.x) - hair}) {
        drawing.fillBox({x, layout.lo.y}, {x + hair, layout.hi.y}, kShadeEdge);
    }
    // The label stands above the range, inside the picture.
    const double half = 0.5 * textWidth(chart.shadedLabel, layout.tickSize);
    const double x =
        std::clamp(0.5 * (lo.x + hi.x), std::min(layout.lo.x + half, layout.hi.x - half), layout.hi.x - half);
    drawing.text({chart.shadedLabel, {x, layout.lo.y - 0.7 * layout.gap()}, layout.tickSize, Align::Centre},
                 kShadedBar);
}

// --- density

// Of how much of the scale of colours a count takes.
struct DensityScale {
    double greatest;
    bool isLogarithmic;

    [[nodiscard]] double part(double count) const {
        return isLogarithmic ? std::log1p(count) / std::log1p(greatest) : count / greatest;
    }
};

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

void putColour(Image& image, int x, int y, Colour colour) {
    std::uint8_t* pixel = image.pixel(x, y);
    pixel[0] = std::uint8_t(std::lround(255 * colour.red));
    pixel[1] = std::uint8_t(std::lround(255 * colour.green));
    pixel[2] = std::uint8_t(std::lround(255 * colour.blue));
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
            putColour(image, x, y, densityColour(meanPart(chart, parts, from, from + cells)));
        }
    }
}

void putColourBar(Image& image, glm::ivec2 lo, glm::ivec2 hi) {
    for (int y = lo.y; y < hi.y; ++y) {
        for (int x = lo.x; x < hi.x; ++x) {
            putColour(image, x, y, densityColour((hi.y - y - 0.5) / (hi.y - lo.y)));
        }
    }
}

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
    drawing.text({label,
                  {right, layout.hi.y + layout.gap() + 3 * layout.scale + kCapHeight * layout.tickSize},
                  layout.tickSize,
                  Align::Right},
                 kQuiet);
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

Image drawChart(const BarChart& chart, glm::ivec2 size) {
    VS_CHECK(!chart.counts.empty() && chart.across.range.width() > 0);
    Layout layout(size);
    const CountScale scale{std::max(1.0, *std::max_element(chart.counts.begin(), chart.counts.end())),
                           chart.isLogarithmic};
    const auto part = [&](double count) { return scale.part(count); };
    // The plot's height decides on the ticks, their width on its own: nearly all of the picture's height is
    // close.
    const auto up = countTicks(scale.greatest, scale.isLogarithmic, 0.8 * size.y, 60 * layout.scale, part);
    const double labelRow = chart.shaded ? layout.tickSize + 0.4 * layout.gap() : 0;
    placePlot(layout, size, widest(up, layout.tickSize), 0, labelRow);
    const auto across = linearTicks(chart.across.range, layout.plotSize().x, 95 * layout.scale);

    Drawing drawing(size);
    drawBars(drawing, chart, layout, scale, up);
    drawAcross(drawing, layout, across, chart.across.label);
    drawUp(drawing, layout, up, chart.countLabel);
    drawHeading(drawing, layout, chart.title, chart.note, layout.hi.x);
    return onPaper(drawing, paper(size));
}

Image drawChart(const DensityChart& chart, glm::ivec2 size) {
    VS_CHECK(chart.counts.size() == std::size_t(chart.bins.x) * std::size_t(chart.bins.y) &&
             chart.across.range.width() > 0 && chart.up.range.width() > 0);
    Layout layout(size);
    const DensityScale scale{std::max(1.0, *std::max_element(chart.counts.begin(), chart.counts.end())),
                             chart.isLogarithmic};
    const auto part = [&](double count) { return scale.part(count); };
    const auto up = linearTicks(chart.up.range, 0.8 * size.y, 60 * layout.scale);
    const auto counts =
        countTicks(scale.greatest, scale.isLogarithmic, 0.8 * size.y, 60 * layout.scale, part);
    const double barWidth = std::round(24 * layout.scale);
    const double besideBar = widest(counts, layout.tickSize) + layout.gap() + 2 * layout.scale;
    placePlot(layout, size, widest(up, layout.tickSize), barWidth + besideBar + 2.5 * layout.gap(), 0);
    const auto across = linearTicks(chart.across.range, layout.plotSize().x, 95 * layout.scale);
    const double barLeft = std::round(layout.hi.x + 2.5 * layout.gap());

    Image image = paper(size);
    putCells(image, chart, layout, scale);
    putColourBar(image, glm::ivec2(glm::dvec2(barLeft, layout.lo.y)),
                 glm::ivec2(glm::dvec2(barLeft + barWidth, layout.hi.y)));
    Drawing drawing(size);
    if (const auto marked = partsOf(chart.marked, chart.across.range)) {
        drawMarks(drawing, layout, *marked);
    }
    drawAcross(drawing, layout, across, chart.across.label);
    drawUp(drawing, layout, up, chart.up.label);
    labelColourBar(drawing, layout, barLeft + barWidth, counts, chart.countLabel);
    drawHeading(drawing, layout, chart.title, chart.note, barLeft + barWidth);
    return onPaper(drawing, std::move(image));
}

} // namespace vs::image

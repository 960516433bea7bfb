// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/axis.h"
#include "image/drawing.h"

#include <optional>
#include <string>
#include <vector>

// What both kinds of charts are made of; for the files that draw them.
namespace vs::image {

inline constexpr Colour kPaper{1, 1, 1};
inline constexpr Colour kText{0.10, 0.11, 0.13};
inline constexpr Colour kQuiet{0.36, 0.39, 0.43};
inline constexpr Colour kGrid{0.90, 0.91, 0.92};
inline constexpr Colour kQuietBar{0.62, 0.66, 0.70};
inline constexpr Colour kBar{0.00, 0.36, 0.58}; // the Okabe-Ito palette's blue, darker
inline constexpr Colour kShade{0.91, 0.955, 0.985};
inline constexpr Colour kShadeEdge{0.25, 0.55, 0.75};

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
    // The room between the edge of the picture and anything, and between two things.
    [[nodiscard]] double margin() const { return 20 * scale; }
    [[nodiscard]] double gap() const { return 9 * scale; }
    // Height of a range's label above the plot.
    [[nodiscard]] double labelRow(bool isThere) const { return isThere ? tickSize + 0.4 * gap() : 0; }
};

double widest(const std::vector<Tick>& ticks, double size);
std::vector<Tick> linearTicks(const Range& range, double pixels, double perTick);

// Ticks for an axis of counts; `part` says which part of the axis is below a count.
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

// Text whose capitals are centred on a height.
Text centredOn(const std::string& text, glm::dvec2 middle, double size, Align align);

// The margins around the plot. Its left one has room for the widest label of the axis upward.
void placePlot(Layout& layout, glm::ivec2 size, double upLabels, double extraRight, double extraTop);
// A range of the axis across as parts of it, within the plot; nothing if it lies outside.
std::optional<Range> partsOf(const std::optional<Range>& range, const Range& across);

// The title at the left and the note at the right of the topmost line. Where both have no room the note loses
// its last parts (between commas), then the title its middle.
void drawHeading(Drawing& drawing, const Layout& layout, const std::string& title, std::string note,
                 double right);
void drawAcross(Drawing& drawing, const Layout& layout, const std::vector<Tick>& ticks,
                const std::string& label);
void drawUp(Drawing& drawing, const Layout& layout, const std::vector<Tick>& ticks, const std::string& label);
// Draws a label above a range of the axis across (given as its parts), but not beyond the plot.
void drawRangeLabel(Drawing& drawing, const Layout& layout, const Range& parts, const std::string& label);

Image paper(glm::ivec2 size);
Image onPaper(const Drawing& drawing, Image image);

} // namespace vs::image

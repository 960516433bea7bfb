// SPDX-License-Identifier: Apache-2.0
#include "reports/measurements.h"

#include "base/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace vs::cli {
namespace {

struct Column {
    std::string title;
    std::vector<std::string> cells;
    bool isText = false;
};

// What is not known is a dash.
std::string number(double value, int digits) {
    return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

// Whole numbers stay such.
std::string intensity(double value) {
    const bool isWhole = value == std::floor(value) && std::abs(value) < 1e9;
    return isWhole ? number(value, 0) : std::isnan(value) ? "-" : fmt::format("{:.5g}", value);
}

// Digits behind the point with which the largest of some numbers has four that count, at least one.
template <typename F>
int digitsFor(const std::vector<MeasuredSegment>& segments, const F& value) {
    double largest = 0;
    for (const MeasuredSegment& segment : segments) {
        const double size = std::abs(value(segment.statistics));
        largest = std::isfinite(size) ? std::max(largest, size) : largest;
    }
    return largest > 0 ? std::clamp(4 - int(std::ceil(std::log10(largest))), 1, 9) : 1;
}

// Digits behind the point that tell the smallest segment's volume well.
int placesFor(const std::vector<MeasuredSegment>& segments) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const MeasuredSegment& segment : segments) {
        smallest = std::min(smallest, segment.statistics.millilitres);
    }
    return smallest < 1 ? 3 : smallest < 10 ? 2 : 1;
}

// Columns as people count: a character's bytes behind the first take no room.
std::size_t widthOf(const std::string& text) {
    return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

template <typename F>
Column column(std::string title, const std::vector<MeasuredSegment>& segments, const F& cell) {
    Column result{std::move(title), {}, false};
    for (const MeasuredSegment& segment : segments) {
        result.cells.push_back(cell(segment, segment.statistics));
    }
    return result;
}

std::vector<Column> columnsOf(const std::vector<MeasuredSegment>& segments) {
    using Segment = const MeasuredSegment&;
    using Statistics = const segment::SegmentStatistics&;
    const auto add = [&](std::vector<Column>& columns, const char* title, const auto& cell) {
        columns.push_back(column(title, segments, cell));
    };
    std::vector<Column> columns;
    add(columns, "label", [](Segment s, Statistics) { return std::to_string(s.label); });
    if (std::any_of(segments.begin(), segments.end(), [](Segment s) { return !s.name.empty(); })) {
        add(columns, "name", [](Segment s, Statistics) { return s.name; });
        columns.back().isText = true;
    }
    add(columns, "voxels", [](Segment, Statistics s) { return std::to_string(s.voxels); });
    const int places = placesFor(segments);
    add(columns, "volume ml", [&](Segment, Statistics s) { return number(s.millilitres, places); });
    add(columns, "surface mm²", [](Segment, Statistics s) { return number(s.surfaceMm2, 0); });
    add(columns, "sphericity", [](Segment, Statistics s) { return number(s.sphericity, 3); });
    const int digits = digitsFor(segments, [](Statistics s) { return s.intensities.mean; });
    add(columns, "mean", [&](Segment, Statistics s) { return number(s.intensities.mean, digits); });
    add(columns, "sd", [&](Segment, Statistics s) { return number(s.intensities.deviation, digits); });
    add(columns, "min", [](Segment, Statistics s) { return intensity(s.intensities.smallest); });
    add(columns, "median", [](Segment, Statistics s) { return intensity(s.intensities.median); });
    add(columns, "max", [](Segment, Statistics s) { return intensity(s.intensities.largest); });
    add(columns, "box mm", [](Segment, Statistics s) {
        return fmt::format("{:.4g} x {:.4g} x {:.4g}", s.boxMm.x, s.boxMm.y, s.boxMm.z);
    });
    add(columns, "axes mm", [](Segment, Statistics s) {
        return fmt::format("{:.4g} x {:.4g} x {:.4g}", s.axes[0].lengthMm, s.axes[1].lengthMm,
                           s.axes[2].lengthMm);
    });
    add(columns, "parts", [](Segment, Statistics s) { return std::to_string(s.topology.parts); });
    add(columns, "tunnels", [](Segment, Statistics s) { return std::to_string(s.topology.tunnels()); });
    add(columns, "cavities", [](Segment, Statistics s) { return std::to_string(s.topology.cavities); });
    add(columns, "centroid mm (LPS)", [](Segment, Statistics s) {
        return fmt::format("{:.1f} {:.1f} {:.1f}", s.centroid.x, s.centroid.y, s.centroid.z);
    });
    return columns;
}

void print(const std::vector<Column>& columns, std::size_t lines) {
    for (std::size_t line = 0; line <= lines; ++line) {
        std::string text;
        for (const Column& column : columns) {
            std::size_t width = widthOf(column.title);
            for (const std::string& cell : column.cells) {
                width = std::max(width, widthOf(cell));
            }
            const std::string& cell = line == 0 ? column.title : column.cells[line - 1];
            const std::string room(width - widthOf(cell), ' ');
            text += text.empty() ? "" : "  ";
            text += column.isText ? cell + room : room + cell;
        }
        fmt::print("{}\n", text);
    }
}

} // namespace

void printTable(const std::vector<MeasuredSegment>& segments) { print(columnsOf(segments), segments.size()); }

void printTable(const std::vector<studio::Measured>& measurements, const volume::GridGeometry& geometry) {
    if (measurements.empty()) {
        return;
    }
    Column numbers{"measurement", {}, false};
    Column kinds{"kind", {}, true};
    Column values{"value", {}, false};
    Column inside{"mean and sd of values", {}, false};
    for (const studio::Measured& measured : measurements) {
        const std::string found = studio::valuesOf(measured);
        numbers.cells.push_back(std::to_string(numbers.cells.size()));
        kinds.cells.emplace_back(nameOf(measured.measure.kind));
        values.cells.push_back(studio::labelOf(measured, geometry));
        inside.cells.push_back(found.empty() ? "-" : found);
    }
    print({numbers, kinds, values, inside}, measurements.size());
}

void printAgreement(const segment::Agreement& agreement) {
    fmt::print("dice                      {:.6f}\n", agreement.dice);
    fmt::print("jaccard                   {:.6f}\n", agreement.jaccard);
    fmt::print("hausdorff_95_mm           {:.6g}\n", agreement.hausdorff95Mm);
    fmt::print("mean_surface_distance_mm  {:.6g}\n", agreement.meanSurfaceMm);
    fmt::print("volume_difference_ml      {:.6g}\n", agreement.volumeDifferenceMl);
    fmt::print("volume_difference_percent {:.6g}\n", agreement.volumeDifferencePercent);
}

} // namespace vs::cli

// SPDX-License-Identifier: Apache-2.0
#include "render/colours/classification_tables.h"

#include <algorithm>
#include <cmath>

namespace vs::render {

namespace {

// The part of `span` where there are values; a single place when there are none in it.
Range clampedTo(const Range& span, const Range& values) {
    return {std::clamp(span.lo, values.lo, values.hi), std::clamp(span.hi, values.lo, values.hi)};
}

// From the first position that means something to the last. Steps at the ends, which are two points in one
// place, lie a little inside, or what is on their other side would be seen as the step's inside is.
Range spanOfPoints(const TransferFunction& function) {
    const auto& points = function.points;
    Range span{points.front().position, points.back().position};
    const double hair = (span.width() > 0 ? span.width() : 1) / kCurveTexels;
    if (points.size() > 1) {
        span.lo -= points[1].position == points[0].position ? hair : 0;
        span.hi += points[points.size() - 2].position == points.back().position ? hair : 0;
    }
    if (function.colours) {
        span = {std::min(span.lo, function.colours->range.lo), std::max(span.hi, function.colours->range.hi)};
    }
    return span;
}

struct Spans {
    Range values;
    Range gradients;
};

// All shapes and a little around them, so that the tables' edges are clear unless the data ends there.
Spans spansOfShapes(const TransferFunction& function) {
    if (function.shapes.empty()) {
        return {};
    }
    Spans spans{{1e300, -1e300}, {1e300, -1e300}};
    const auto include = [](Range& span, const Range& part) {
        span = {std::min(span.lo, part.lo), std::max(span.hi, part.hi)};
    };
    for (const Shape& shape : function.shapes) {
        if (const auto* trapezoid = std::get_if<Trapezoid>(&shape.form)) {
            include(spans.values, trapezoid->base);
            include(spans.values, trapezoid->top);
            include(spans.gradients, trapezoid->gradients);
        } else {
            include(spans.values, std::get<Painting>(shape.form).values);
            include(spans.gradients, std::get<Painting>(shape.form).gradients);
        }
    }
    constexpr double margin = 0.01;
    const double x = margin * spans.values.width();
    const double y = margin * spans.gradients.width();
    return {{spans.values.lo - x, spans.values.hi + x},
            {std::max(spans.gradients.lo - y, 0.0), spans.gradients.hi + y}};
}

double placeOf(int texel, int count, const Range& span) {
    return count > 1 ? span.lo + span.width() * texel / (count - 1) : span.lo;
}

void fillMain(ClassificationTables& tables, const TransferFunction& function, double unitSteps) {
    const FunctionSampler sampler(function);
    const bool isGradient = function.kind == FunctionKind::Gradient;
    const int pitch = function.kind == FunctionKind::TwoD ? kPlanePitch : 1;
    tables.main.resize(std::size_t(tables.size.x) * std::size_t(tables.size.y));
    for (int j = 0; j < tables.size.y; j += pitch) {
        const double gradient = placeOf(j, tables.size.y, tables.gradients);
        for (int i = 0; i < tables.size.x; i += pitch) {
            const double across = placeOf(i, tables.size.x, isGradient ? tables.gradients : tables.values);
            glm::dvec4 c = sampler.at(across, isGradient ? across : gradient);
            c.w = c.w > 0 ? opacityOver(c.w, 1 / unitSteps) : 0;
            tables.main[std::size_t(j * tables.size.x + i)] = glm::vec4(c);
        }
    }
}

// The texels between those that fillMain() asked the function for.
void fillBetween(ClassificationTables& tables) {
    static_assert(kPlanePitch == 2);
    const int width = tables.size.x;
    const auto at = [&](int i, int j) -> glm::vec4& { return tables.main[std::size_t(j * width + i)]; };
    for (int j = 0; j < tables.size.y; j += 2) {
        for (int i = 1; i < width; i += 2) {
            at(i, j) = 0.5F * (at(i - 1, j) + at(i + 1, j));
        }
    }
    for (int j = 1; j < tables.size.y; j += 2) {
        for (int i = 0; i < width; ++i) {
            at(i, j) = 0.5F * (at(i, j - 1) + at(i, j + 1));
        }
    }
}

// Optical depth per step; what is opaque still lets a millionth through.
double depthOf(double opacity) { return -std::log(1 - std::min(opacity, 1 - 1e-6)); }

// Optical depths per step and colours weighted by them, summed over all columns before each and after the
// last.
std::vector<glm::dvec4> sumsOf(const std::vector<glm::vec4>& columns) {
    std::vector<glm::dvec4> sums{glm::dvec4(0)};
    for (const glm::vec4& c : columns) {
        sums.push_back(sums.back() + depthOf(double(c.w)) * glm::dvec4(glm::dvec3(c), 1.0));
    }
    return sums;
}

// The sum up to a place between columns; the outermost go on outside.
glm::dvec4 sumUpTo(double x, const std::vector<glm::dvec4>& sums) {
    const double column = std::clamp(std::floor(x), 0.0, double(sums.size()) - 2);
    const auto i = std::size_t(column);
    return sums[i] + (x - column) * (sums[i + 1] - sums[i]);
}

glm::vec4 meanOfSpan(double from, double to, const std::vector<glm::dvec4>& sums) {
    const glm::dvec4 sum = sumUpTo(to, sums) - sumUpTo(from, sums);
    // Differences of sums may leave a trace of what is not there.
    if (sum.w <= 1e-12 * sums.back().w) {
        return glm::vec4(0);
    }
    return {glm::vec3(glm::dvec3(sum) / sum.w), float(1 - std::exp(-0.5 * sum.w / (to - from)))};
}

void fillSpans(ClassificationTables& tables) {
    const auto sums = sumsOf(tables.main);
    const int texels = int(tables.main.size()) + 2 * kSpanMargin;
    tables.spans.reserve(std::size_t(texels) * kSpanRows);
    for (int row = 0; row < kSpanRows; ++row) {
        const int octave = row / 4;
        const int pitch = 1 << std::max(octave - 3, 0); // columns of `main` for each
        const double width = double(1 << octave) * (1 + 0.25 * (row % 4)) - (pitch - 1);
        for (int i = -kSpanMargin; i < texels - kSpanMargin; ++i) {
            const double middle = (i + 0.5) * pitch;
            tables.spans.push_back(meanOfSpan(middle - 0.5 * width, middle + 0.5 * width, sums));
        }
    }
}

// Sums over all rectangles from the first texel (Crow 1984, "Summed-area tables for texture mapping").
void countVisible(ClassificationTables& tables, FunctionKind kind) {
    const glm::ivec2 size = kind == FunctionKind::Gradient ? glm::ivec2(1, tables.size.x) : tables.size;
    tables.visibleSize = size + 1;
    const auto width = std::size_t(tables.visibleSize.x);
    auto& sums = tables.visibleBefore;
    sums.assign(width * std::size_t(tables.visibleSize.y), 0);
    for (std::size_t j = 1; j <= std::size_t(size.y); ++j) {
        std::uint32_t inRow = 0;
        for (std::size_t i = 1; i < width; ++i) {
            inRow += tables.main[(j - 1) * (width - 1) + i - 1].w > 0 ? 1 : 0;
            sums[j * width + i] = sums[(j - 1) * width + i] + inRow;
        }
    }
}

} // namespace

ClassificationTables makeTables(const TransferFunction& absolute, const Range& dataValues, double stepMm) {
    ClassificationTables tables;
    if (absolute.kind == FunctionKind::TwoD) {
        const Spans spans = spansOfShapes(absolute);
        tables.size = kPlaneTexels;
        tables.values = clampedTo(spans.values, dataValues);
        tables.gradients = spans.gradients;
    } else {
        tables.size = {kCurveTexels, 1};
        const Range span = spanOfPoints(absolute);
        (absolute.kind == FunctionKind::Gradient ? tables.gradients : tables.values) =
            absolute.kind == FunctionKind::Gradient ? span : clampedTo(span, dataValues);
    }
    fillMain(tables, absolute, absolute.unitMm ? *absolute.unitMm / stepMm : 1);
    if (absolute.kind == FunctionKind::Intensity) {
        fillSpans(tables);
    }
    if (absolute.kind == FunctionKind::TwoD) {
        fillBetween(tables);
    }
    countVisible(tables, absolute.kind);
    return tables;
}

} // namespace vs::render

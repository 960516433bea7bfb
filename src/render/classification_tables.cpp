// SPDX-License-Identifier: Apache-2.0
#include "render/classification_tables.h"

#include <algorithm>
#include <cmath>

namespace vs::render {

namespace {

// The part of `span` where there are values; a single place when there are none in it.
Range clampedTo(const Range& span, const Range& values) {
    return {std::clamp(span.lo, values.lo, values.hi), std::clamp(span.hi, values.lo, values.hi)};
}

// From the first position that means something to the last.
Range spanOfPoints(const TransferFunction& function) {
    Range span{function.points.front().position, function.points.back().position};
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
    tables.main.reserve(std::size_t(tables.size.x) * std::size_t(tables.size.y));
    for (int j = 0; j < tables.size.y; ++j) {
        const double gradient = placeOf(j, tables.size.y, tables.gradients);
        for (int i = 0; i < tables.size.x; ++i) {
            const double across = placeOf(i, tables.size.x, isGradient ? tables.gradients : tables.values);
            glm::dvec4 c = sampler.at(across, isGradient ? across : gradient);
            c.w = c.w > 0 ? opacityOver(c.w, 1 / unitSteps) : 0;
            tables.main.emplace_back(c);
        }
    }
}

void countVisible(ClassificationTables& tables, bool valuesTell) {
    const int columns = valuesTell ? tables.size.x : 1;
    std::vector<bool> isVisible(std::size_t(columns), false);
    for (std::size_t i = 0; i < tables.main.size(); ++i) {
        const std::size_t column = valuesTell ? i % std::size_t(columns) : 0;
        isVisible[column] = isVisible[column] || tables.main[i].w > 0;
    }
    tables.visibleBefore = {0};
    for (const bool seen : isVisible) {
        tables.visibleBefore.push_back(tables.visibleBefore.back() + (seen ? 1 : 0));
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
    countVisible(tables, absolute.kind != FunctionKind::Gradient);
    return tables;
}

} // namespace vs::render

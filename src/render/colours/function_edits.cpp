// SPDX-License-Identifier: Apache-2.0
#include "render/colours/function_edits.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>

namespace vs::render {

namespace {

Colour colourAt(const TransferFunction& function, double at) {
    TransferFunction absolute = function;
    absolute.positions = Positions::Absolute; // positions are compared with one another only
    return colourFromLinear(glm::dvec3(FunctionSampler(absolute).at(at, at)));
}

double opacityAt(const TransferFunction& function, double at) {
    TransferFunction absolute = function;
    absolute.positions = Positions::Absolute;
    return FunctionSampler(absolute).at(at, at).w;
}

double lowerNeighbour(const TransferFunction& function, std::size_t point) {
    return point > 0 ? function.points[point - 1].position : -std::numeric_limits<double>::infinity();
}

double upperNeighbour(const TransferFunction& function, std::size_t point) {
    return point + 1 < function.points.size() ? function.points[point + 1].position
                                              : std::numeric_limits<double>::infinity();
}

} // namespace

Colour nextSafeColour(const TransferFunction& function) {
    const auto isUsed = [&](Colour colour) {
        return std::any_of(function.points.begin(), function.points.end(),
                           [&](const ControlPoint& point) { return point.colour == colour; }) ||
               std::any_of(function.shapes.begin(), function.shapes.end(),
                           [&](const Shape& shape) { return shape.colour == colour; });
    };
    for (const Colour colour : kSafeColours) {
        if (!isUsed(colour)) {
            return colour;
        }
    }
    return kSafeColours[(function.points.size() + function.shapes.size()) % kSafeColours.size()];
}

TransferFunction functionOfRange(const Range& range) {
    const double width = range.hi - range.lo;
    TransferFunction function;
    function.name = "displayed range";
    // From the middle of the map on: its dark colours would not tell from shade.
    function.colours = SpreadColours{"ivory", {range.lo - width, range.hi}};
    function.points = {{range.lo, 0}, {range.lo + 0.1 * width, 0.2}, {range.hi, 0.6}, {range.hi, 0}};
    return function;
}

TransferFunction functionOfGradients(double top) {
    TransferFunction function;
    function.name = "edges";
    function.kind = FunctionKind::Gradient;
    function.colours = SpreadColours{"marine", {0, top}};
    function.points = {{0.1 * top, 0}, {0.3 * top, 0.05}, {0.6 * top, 0.35}, {top, 0.8}};
    return function;
}

TransferFunction functionOfBoth(const Range& range, double gradientTop) {
    TransferFunction function;
    function.name = "intensity and gradient";
    function.kind = FunctionKind::TwoD;
    function.unitMm = 1;
    const Trapezoid box{range, range, {0.15 * gradientTop, 0.9 * gradientTop}, {0.3, 0.3}};
    function.shapes = {{box, kSafeColours[0], 0.4}};
    return function;
}

// --- points

std::size_t addPoint(TransferFunction& function, double at, double opacity) {
    ControlPoint point{at, std::clamp(opacity, 0.0, 1.0), Colour(255)};
    if (!function.points.empty()) {
        point.colour = colourAt(function, at);
    }
    const auto place =
        std::upper_bound(function.points.begin(), function.points.end(), at,
                         [](double p, const ControlPoint& other) { return p < other.position; });
    const auto number = std::size_t(place - function.points.begin());
    function.points.insert(place, point);
    return number;
}

void movePoint(TransferFunction& function, std::size_t point, double at, double opacity) {
    ControlPoint& moved = function.points.at(point);
    moved.position = std::clamp(at, lowerNeighbour(function, point), upperNeighbour(function, point));
    moved.opacity = std::clamp(opacity, 0.0, 1.0);
}

bool removePoint(TransferFunction& function, std::size_t point) {
    if (function.points.size() < 2) {
        return false;
    }
    function.points.erase(function.points.begin() + std::ptrdiff_t(point));
    return true;
}

void paintPoint(TransferFunction& function, std::size_t point, Colour colour) {
    useOwnColours(function);
    function.points.at(point).colour = colour;
}

std::optional<Hill> hillAt(const TransferFunction& function, double at, double opacity) {
    const auto& points = function.points;
    if (points.size() < 2 || at < points.front().position || at > points.back().position ||
        opacity >= opacityAt(function, at)) {
        return std::nullopt;
    }
    std::size_t last = 1;
    while (last + 1 < points.size() && points[last].position <= at) {
        ++last;
    }
    std::size_t first = last - 1;
    while (first > 0 && points[first].opacity > 0) {
        --first;
    }
    while (last + 1 < points.size() && points[last].opacity > 0) {
        ++last;
    }
    return Hill{first, last};
}

void moveHill(TransferFunction& function, const Hill& hill, double by, double times) {
    auto& points = function.points;
    VS_CHECK(hill.first <= hill.last && hill.last < points.size());
    by = std::clamp(by, lowerNeighbour(function, hill.first) - points[hill.first].position,
                    upperNeighbour(function, hill.last) - points[hill.last].position);
    for (std::size_t i = hill.first; i <= hill.last; ++i) {
        points[i].position += by;
        points[i].opacity = std::clamp(times * points[i].opacity, 0.0, 1.0);
    }
}

Hill addBox(TransferFunction& function, const Range& range, double opacity, Colour colour) {
    useOwnColours(function);
    auto& points = function.points;
    const bool isFirst = points.empty();
    const ControlPoint before{range.lo, isFirst ? 0 : opacityAt(function, range.lo),
                              isFirst ? colour : colourAt(function, range.lo)};
    const ControlPoint after{range.hi, isFirst ? 0 : opacityAt(function, range.hi),
                             isFirst ? colour : colourAt(function, range.hi)};
    std::erase_if(points, [&](const ControlPoint& point) {
        return point.position >= range.lo && point.position <= range.hi;
    });
    const double side = 0.15 * range.width();
    std::vector<ControlPoint> box{{range.lo, 0, colour},
                                  {range.lo + side, opacity, colour},
                                  {range.hi - side, opacity, colour},
                                  {range.hi, 0, colour}};
    // What lies beside the box stays as it was.
    const bool keepsBefore = before.opacity > 0;
    if (keepsBefore) {
        box.insert(box.begin(), before);
    }
    if (after.opacity > 0) {
        box.push_back(after);
    }
    const auto place =
        std::lower_bound(points.begin(), points.end(), range.lo,
                         [](const ControlPoint& point, double p) { return point.position < p; });
    const std::size_t first = std::size_t(place - points.begin()) + (keepsBefore ? 1 : 0);
    points.insert(place, box.begin(), box.end());
    return {first, first + 3};
}

void useColourMap(TransferFunction& function, const std::string& map) {
    VS_CHECK(function.kind != FunctionKind::TwoD && !function.points.empty());
    Range range{function.points.front().position, function.points.back().position};
    if (function.colours) {
        range = function.colours->range; // only other colours, in the same places
    }
    function.colours = SpreadColours{map, range};
}

void useOwnColours(TransferFunction& function) {
    if (function.colours) {
        for (ControlPoint& point : function.points) {
            point.colour = colourAt(function, point.position);
        }
        function.colours.reset();
    }
}

} // namespace vs::render

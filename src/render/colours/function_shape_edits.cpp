// SPDX-License-Identifier: Apache-2.0
#include "render/colours/function_edits.h"

#include <algorithm>
#include <cmath>

namespace vs::render {

void addShape(TransferFunction& function, Shape shape) {
    function.shapes.insert(function.shapes.begin(), std::move(shape));
}

void removeShape(TransferFunction& function, std::size_t shape) {
    function.shapes.erase(function.shapes.begin() + std::ptrdiff_t(shape));
}

namespace {

bool holds(const Trapezoid& shape, glm::dvec2 place) {
    const double height = shape.gradients.width();
    const double s = height > 0 ? (place.y - shape.gradients.lo) / height : 0;
    return s >= 0 && s <= 1 && place.x >= glm::mix(shape.base.lo, shape.top.lo, s) &&
           place.x <= glm::mix(shape.base.hi, shape.top.hi, s);
}

// Where a place lies among a painting's cells; centres at whole numbers.
glm::dvec2 cellOf(const Painting& painting, glm::dvec2 place) {
    return {
        (place.x - painting.values.lo) / std::max(painting.values.width(), 1e-300) * painting.size.x - 0.5,
        (place.y - painting.gradients.lo) / std::max(painting.gradients.width(), 1e-300) * painting.size.y -
            0.5};
}

bool holds(const Painting& painting, glm::dvec2 place) {
    const glm::ivec2 cell(glm::round(cellOf(painting, place)));
    return cell.x >= 0 && cell.y >= 0 && cell.x < painting.size.x && cell.y < painting.size.y &&
           painting.cells[std::size_t(cell.y) * std::size_t(painting.size.x) + std::size_t(cell.x)] > 0;
}

void shift(Range& range, double by) {
    range.lo += by;
    range.hi += by;
}

} // namespace

std::optional<std::size_t> shapeAt(const TransferFunction& function, glm::dvec2 place) {
    for (std::size_t i = 0; i < function.shapes.size(); ++i) {
        if (std::visit([&](const auto& form) { return holds(form, place); }, function.shapes[i].form)) {
            return i;
        }
    }
    return std::nullopt;
}

void moveShape(Shape& shape, glm::dvec2 by) {
    if (auto* trapezoid = std::get_if<Trapezoid>(&shape.form)) {
        shift(trapezoid->base, by.x);
        shift(trapezoid->top, by.x);
        shift(trapezoid->gradients, by.y);
    } else {
        auto& painting = std::get<Painting>(shape.form);
        shift(painting.values, by.x);
        shift(painting.gradients, by.y);
    }
}

std::array<glm::dvec2, 4> cornersOf(const Trapezoid& shape) {
    return {{{shape.base.lo, shape.gradients.lo},
             {shape.base.hi, shape.gradients.lo},
             {shape.top.lo, shape.gradients.hi},
             {shape.top.hi, shape.gradients.hi}}};
}

void moveCorner(Trapezoid& shape, std::size_t corner, glm::dvec2 to) {
    Range& across = corner < 2 ? shape.base : shape.top;
    if (across.width() <= 0) {
        across = {to.x, to.x};
    } else if (corner % 2 == 0) {
        across.lo = std::min(to.x, across.hi);
    } else {
        across.hi = std::max(to.x, across.lo);
    }
    if (corner < 2) {
        shape.gradients.lo = std::min(to.y, shape.gradients.hi);
    } else {
        shape.gradients.hi = std::max(to.y, shape.gradients.lo);
    }
}

Shape makePainting(const Range& values, const Range& gradients, Colour colour) {
    constexpr glm::ivec2 kCells{96, 48}; // as fine as a hand paints on a chart of a panel
    Painting painting{values, gradients, kCells, {}};
    painting.cells.assign(std::size_t(kCells.x) * std::size_t(kCells.y), 0);
    return {painting, colour, 0.5};
}

void paintStroke(Painting& painting, glm::dvec2 from, glm::dvec2 to, glm::dvec2 radius, bool erases) {
    const glm::dvec2 cells =
        glm::dvec2(painting.size) /
        glm::max(glm::dvec2(painting.values.width(), painting.gradients.width()), glm::dvec2(1e-300));
    const glm::dvec2 reach = glm::max(radius * cells, glm::dvec2(0.75)); // at least the cell under the pen
    const glm::dvec2 a = cellOf(painting, from) / reach;
    const glm::dvec2 along = cellOf(painting, to) / reach - a;
    const double length2 = std::max(glm::dot(along, along), 1e-12);
    for (int y = 0; y < painting.size.y; ++y) {
        for (int x = 0; x < painting.size.x; ++x) {
            const glm::dvec2 p = glm::dvec2(x, y) / reach - a;
            const double distance =
                glm::length(p - std::clamp(glm::dot(p, along) / length2, 0.0, 1.0) * along);
            // Full in the inner half, then a smooth fall.
            const double t = std::clamp(2 - 2 * distance, 0.0, 1.0);
            const auto amount = int(std::lround(255 * t * t * (3 - 2 * t)));
            auto& cell = painting.cells[std::size_t(y) * std::size_t(painting.size.x) + std::size_t(x)];
            cell = std::uint8_t(erases ? std::min(int(cell), 255 - amount) : std::max(int(cell), amount));
        }
    }
}

} // namespace vs::render

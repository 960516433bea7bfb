// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/colours/transfer_function.h"

#include <array>
#include <cstddef>

namespace vs::render {

// What a person does to a transfer function on a chart of it. All positions are the function's own; opacities
// are held to 0..1. Points stay in ascending order and keep their numbers while they are moved.

// Colours for things that must be told apart, colour-blind or not (Okabe and Ito 2008, "Color universal
// design").
inline constexpr std::array<Colour, 7> kSafeColours{{{230, 159, 0},
                                                     {86, 180, 233},
                                                     {0, 158, 115},
                                                     {240, 228, 66},
                                                     {0, 114, 178},
                                                     {213, 94, 0},
                                                     {204, 121, 167}}};
// The first of kSafeColours that a function does not use yet.
Colour nextSafeColour(const TransferFunction& function);

// What volume mode shows when no transfer function was chosen: the displayed range, thin at its lower end.
TransferFunction functionOfRange(const Range& range);
// What to begin with over gradient magnitudes from 0 to `top` (edges, the steeper the denser) and over both
// (one box: the range, with little gradient).
TransferFunction functionOfGradients(double top);
TransferFunction functionOfBoth(const Range& range, double gradientTop);

// --- points (Intensity, Gradient)

// A new point with the colour that the function has there; returns its number.
std::size_t addPoint(TransferFunction& function, double at, double opacity);
// Moves a point, between its neighbours.
void movePoint(TransferFunction& function, std::size_t point, double at, double opacity);
// Removes a point. False: it is the last one, which stays.
bool removePoint(TransferFunction& function, std::size_t point);
// Gives a point a colour. A function with a colour map gets colours of its own first.
void paintPoint(TransferFunction& function, std::size_t point, Colour colour);

// Points from one without opacity to the next one without: what looks like a hill or a box on the chart.
struct Hill {
    std::size_t first = 0;
    std::size_t last = 0;

    bool operator==(const Hill&) const = default;
};
// The hill that a place of the chart lies under; nothing where it is above the curve.
std::optional<Hill> hillAt(const TransferFunction& function, double at, double opacity);
// Moves a hill along and makes its opacities `times` as great, none beyond 1. It stays between its
// neighbours.
void moveHill(TransferFunction& function, const Hill& hill, double by, double times);
// A box with sloping sides instead of what the function has over a range.
Hill addBox(TransferFunction& function, const Range& range, double opacity, Colour colour);

// Spreads a named map over all points, instead of their colours.
void useColourMap(TransferFunction& function, const std::string& map);
// Each point gets the colour that it has by the map.
void useOwnColours(TransferFunction& function);

// --- shapes (TwoD); a place is (intensity, gradient magnitude)

// Adds a shape in front of all others, as number 0.
void addShape(TransferFunction& function, Shape shape);
void removeShape(TransferFunction& function, std::size_t shape);
// The foremost shape at a place; of paintings, only where something is painted.
std::optional<std::size_t> shapeAt(const TransferFunction& function, glm::dvec2 place);
void moveShape(Shape& shape, glm::dvec2 by);

// The corners of a trapezoid: lower left, lower right, upper left, upper right.
std::array<glm::dvec2, 4> cornersOf(const Trapezoid& trapezoid);
// Moves a corner. Ends that are a single point stay one, so that triangles stay triangles; no corner passes
// its opposite.
void moveCorner(Trapezoid& trapezoid, std::size_t corner, glm::dvec2 to);

// An empty canvas to paint on.
Shape makePainting(const Range& values, const Range& gradients, Colour colour);
// A round brush with a soft edge (`radius` in each quantity) from one place to another: adds to the painting,
// or takes away.
void paintStroke(Painting& painting, glm::dvec2 from, glm::dvec2 to, glm::dvec2 radius, bool erases);

} // namespace vs::render

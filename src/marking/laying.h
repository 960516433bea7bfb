// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "marking/mark_layer.h"
#include "marking/mark_shape.h"
#include "marking/relief.h"
#include "volume/grid/geometry.h"

#include <functional>

namespace vs::marking {

// What marks are laid on: a surface as a picture shows it.
struct Ground {
    const Relief* relief = nullptr;
    const volume::GridGeometry* geometry = nullptr;
    std::function<glm::dvec2(const glm::dvec3& world)> pixelOf;
};

// How a mark goes into the material and how it ends.
struct Rim {
    double depthMm = 1; // the surface's material is marked so far below it, and above where it is moved there
    double softMm = 0;  // from the edge inwards opacity grows over this; 0: the edge is sharp
};

// What a mark comes to at a place of the surface and the pixel where that is seen.
using Shape = std::function<OnLine(const glm::dvec3& onSurface, glm::dvec2 pixel)>;

// Covers the texels of the material about the surface that pixels from lo to hi (exclusive) show, which the
// relief must know, wherever they lie in a shape: those within its depth of the surface, each where the
// surface is that its own pixel shows.
void lay(MarkLayer& layer, const Ground& ground, const Shape& shape, const Rim& rim, glm::ivec2 lo,
         glm::ivec2 hi);

} // namespace vs::marking

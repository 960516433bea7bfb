// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/drawing.h"

namespace vs::image {

// Colours from nearly black (0) over violet, red and orange to a pale yellow (1) that grow lighter all the
// way and differ by as much as their numbers do, to the eye: evenly spaced along a curve in Oklab (Ottosson
// 2020, "A perceptual color space for image processing"). They can be told apart in grey print and by the
// colour-blind.
Colour densityColour(double part);

// Lightness and the two opponent axes of a display colour in Oklab.
glm::dvec3 oklab(Colour colour);

} // namespace vs::image

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace vs::image {

// How far two pictures are apart, over the red, green and blue bytes of all pixels (0..255).
struct Difference {
    int max = 0;
    double mean = 0;
    double changedFraction = 0; // pixels of which some channel differs by more than 8
};

// Compares two pictures. Throws Error if their sizes differ, naming both.
Difference compare(const Image& a, const Image& b);

} // namespace vs::image

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "sculpt/mask/mask.h"

namespace vs::sculpt {

// A picture as a mask (the maple leaf of the thesis, section 3.6.2), `width` wide in the mask's unit and
// centred on its origin, with the picture's top towards +y. A picture with any transparency counts by its
// alpha, else by its luminance (Rec. 709 weights of the stored values): grey values are coverage, so half and
// more is inside, bright is inside, and antialiased edges stay as smooth as they were drawn. Pixels finer
// than `pitch` are averaged in square blocks of as many as fit. A rim of zeros surrounds the picture. Throws
// Error if the picture is empty.
MaskRaster maskFromImage(const image::Image& picture, double width, double pitch = 0.5);

} // namespace vs::sculpt

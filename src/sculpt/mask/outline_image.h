// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "sculpt/mask/outline.h"

namespace vs::sculpt {

// The outline of what a picture shows as inside (as maskFromImage() reads it), `width` wide, centred on the
// origin, the picture's top towards +y: what makes a picture a sketch that every tool takes. Pictures are
// read at most kOutlineElements wide. Where there are several pieces and holes, lines to and fro join them
// into one outline, which the even-odd rule does not see. Throws Error when nothing is inside.
inline constexpr int kOutlineElements = 256;
Outline outlineFromImage(const image::Image& picture, double width);

} // namespace vs::sculpt

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "base/phrase.h"

#include <array>

namespace vs::render {

// Windows that radiologists look at slices of computed tomography through, in Hounsfield units, from black to
// white: level and width as they are usual (they differ a little from place to place).
struct SliceWindow {
    const char* name;  // in settings and for scripts
    const char* title; // for people
    Range range;
};

// A window by its middle (level) and width.
constexpr Range windowOf(double level, double width) { return {level - width / 2, level + width / 2}; }

inline constexpr Range kAbdomenWindow = windowOf(50, 400);
inline constexpr std::array<SliceWindow, 5> kSliceWindows{
    {{"brain", VS_TEXT("library", "Brain"), windowOf(40, 80)},
     {"bone", VS_TEXT("library", "Bone"), windowOf(400, 1800)},
     {"lung", VS_TEXT("library", "Lung"), windowOf(-600, 1500)},
     {"abdomen", VS_TEXT("library", "Abdomen"), kAbdomenWindow},
     {"vessels", VS_TEXT("library", "Vessels"), windowOf(200, 600)}}};

} // namespace vs::render

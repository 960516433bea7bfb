// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace vs::sculpt {

// Filters that make a mask's grey values of its sub-samples (thesis, section 3.5.2).
enum class Reconstruction { Box, Tent, Gaussian, CatmullRom, MitchellNetravali, BSpline };
inline constexpr std::array<const char*, 6> kReconstructions{"box",         "tent",     "gaussian",
                                                             "catmull-rom", "mitchell", "bspline"};
constexpr const auto& namesOf(Reconstruction) { return kReconstructions; }
// The whole support in which a filter has its natural size, in sub-samples, ten an element.
constexpr int naturalWidth(Reconstruction reconstruction) {
    return reconstruction == Reconstruction::Box ? 10 : reconstruction == Reconstruction::Tent ? 20 : 40;
}

// The cubic B-spline, support [-2, 2] (thesis, section 3.5.2, as corrected in doc/behaviour.md, "Where we
// part from the thesis").
double cubicBSpline(double x);

// The family of cubics of Mitchell and Netravali 1988, "Reconstruction filters in computer graphics", support
// [-2, 2]: (1, 0) is the B-spline, (0, 1/2) Catmull-Rom, (1/3, 1/3) the one they recommend.
double mitchellNetravali(double x, double b, double c);

// Weights of the sub-samples of a filter whose whole support is `width` of them (fewer than 4 count as 4),
// from the first to the last that it touches: an even number, symmetric about the element's centre, which
// lies between two sub-samples. They sum to 1. The support is [-1, 1] of the tent, [-2, 2] of the cubics and
// 3 sigma either side of the Gaussian.
std::vector<float> reconstructionWeights(Reconstruction reconstruction, int width);

} // namespace vs::sculpt

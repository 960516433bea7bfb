// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "phantom/tissue_painter.h"

#include <cstdint>

namespace vs::phantom {

// What the head phantom's labels say. Scalp is all soft tissue outside the skull's inside: skin, fat, muscle,
// eyes, and the veins and optic nerves that pass through the skull.
enum class HeadTissue : std::uint8_t { Air, Scalp, Skull, Csf, Grey, White, Ventricle };

// Intensities of a T1-weighted picture, before noise and bias.
namespace t1 {
inline constexpr double air = 0;
inline constexpr double bone = 14;
inline constexpr double fluid = 40;
inline constexpr double muscle = 74;
inline constexpr double vessel = 92;
inline constexpr double grey = 98;
inline constexpr double marrow = 112;
inline constexpr double skin = 118;
inline constexpr double white = 140;
inline constexpr double fat = 200;
} // namespace t1

// Paints the tissues at one place of an analytic head over air. `p` in mm from the middle of a box of
// 181 x 217 x 181 mm (x to the left, y backwards, z up), `voxelMm` the size of a voxel there.
TissuePainter paintHead(glm::dvec3 p, double voxelMm);

} // namespace vs::phantom

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/path/path.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vs::sculpt {

// Chords of a path: how far they may be from the curve, in steps, and by how much a piece may turn, in
// radians. A mask's element at a distance d from the axis of a turn is off by d * turn^2 / 8: 0.01 at 30
// steps.
inline constexpr double kChordTolerance = 0.01;
inline constexpr double kChordTurn = 0.05;

// What a path may have: 57 MB of samples and pieces.
inline constexpr std::size_t kMostSamples = std::size_t(1) << 18U;

// A point of a curve. Two successive samples at the same place with different tangents are a corner.
struct CurveSample {
    glm::dvec3 point{0};
    glm::dvec3 tangent{0, 0, 1}; // unit
    glm::dvec3 curvature{0};     // second derivative by length: across the tangent, zero where straight
};

// Adds a sample. Throws Error beyond kMostSamples.
void append(std::vector<CurveSample>& samples, const CurveSample& sample);

// Frames at the samples and the pieces between them; at corners the mask turns on the spot. Fewer than two
// samples give nothing.
std::vector<PathPiece> framesAlong(std::span<const CurveSample> samples, FrameKind kind);

} // namespace vs::sculpt

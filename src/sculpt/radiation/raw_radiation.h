// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/mask/mask.h"
#include "sculpt/path/path.h"
#include "sculpt/radiation/radiation.h"

#include <span>
#include <vector>

namespace vs::sculpt {

// The uncalibrated energy of the thesis, section B.5.3, for its experiments: each element of a mask radiates
// this strength times its value wherever the mask stands, whatever the mask's pitch and the footprint. So
// what is inside grows with the number of elements a voxel and, for a mask standing still, with the
// footprint's radius.
inline constexpr float kRawStrength = 0.1F;

// The frames of a mask moved along a path (in steps) by one step at a time: at its start, and wherever its
// origin has gone another whole step. Turns on the spot count none. Throws Error for paths of more than 4096
// steps.
std::vector<MaskFrame> framesEachStep(std::span<const PathPiece> path);

// Radiates a mask (in steps) standing in each of the frames, with raw energy, into a grid of `dims` voxels.
// Afterwards `radiator` holds the result, which is not bounded by 1. Returns the box of voxels that may have
// energy.
Box3 radiateRaw(Radiator& radiator, const MaskRaster& mask, std::span<const MaskFrame> frames,
                glm::ivec3 dims, const Footprint& footprint,
                const glm::dvec3& voxelFromSteps = glm::dvec3(1));
// Does so as far as it comes `within` a box of the grid (Radiator::begin()).
Box3 radiateRaw(Radiator& radiator, const MaskRaster& mask, std::span<const MaskFrame> frames,
                glm::ivec3 dims, const Box3& within, const Footprint& footprint,
                const glm::dvec3& voxelFromSteps);
// The voxels in which the points of that are.
Box3 rawPointBox(const MaskRaster& mask, std::span<const MaskFrame> frames, const glm::dvec3& voxelFromSteps);

} // namespace vs::sculpt

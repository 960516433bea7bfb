// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/mask.h"
#include "sculpt/path.h"
#include "sculpt/radiation.h"
#include "sculpt/tool_points.h"

#include <span>

namespace vs::sculpt {

// The pitch, in voxels, at which masks for sweeping are best rasterized: fine enough for the samples between
// elements.
inline constexpr double kSweepPitch = 0.5;

// The solid that a mask (in voxels) sweeps along one piece of a path in voxel space: density 1 inside, its
// ends exactly at the piece's ends.
SweptPatches sweepPiece(const MaskRaster& mask, const PathPiece& piece);

// Radiates a mask swept along a path into a volume built from nothing (SPEC 6). Afterwards `radiator` holds
// the result. Returns the box of voxels that may have energy.
Box3 sweepMask(Radiator& radiator, PointGenerator& generator, const MaskRaster& mask,
               std::span<const PathPiece> path, glm::ivec3 dims, const Footprint& footprint);

} // namespace vs::sculpt

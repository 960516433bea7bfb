// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/mask/mask.h"
#include "sculpt/path/path.h"
#include "sculpt/radiation/radiation.h"
#include "sculpt/radiation/tool_points.h"

#include <span>
#include <vector>

namespace vs::sculpt {

// The pitch, in steps, at which masks for sweeping are best rasterized: fine enough for the samples between
// elements.
inline constexpr double kSweepPitch = 0.5;

// Voxels per step along each axis of a grid of this spacing (mm): takes paths and masks from the space of
// steps to voxel space.
glm::dvec3 voxelFromSteps(const glm::dvec3& spacing);

// The footprint that solids made from nothing are radiated with on a grid of this spacing: the Gaussian of
// `radius` (2, 3 or 4), smooth where slices are coarse.
Footprint sweepFootprint(int radius, const glm::dvec3& spacing);

// The grid that a sweep goes into.
struct SweepGrid {
    glm::dvec3 voxelFromSteps{1};
    glm::vec3 density{1}; // as SweptPatches::setDensity() takes it
    // What lies beyond these corners, in voxel space, may be left out.
    glm::vec3 lo{-1e30F};
    glm::vec3 hi{1e30F};

    // Where paths matter that a mask in this window (in steps) is led along.
    [[nodiscard]] PathRegion region(const MaskWindow& mask) const;
};

// The grid of these dimensions as solids radiated with `footprint` go into it.
SweepGrid sweepGrid(const glm::ivec3& dims, const Footprint& footprint,
                    const glm::dvec3& voxelFromSteps = glm::dvec3(1));

// What of a window of the mask's plane may come into the grid on a piece of a path: all that does, and little
// more.
MaskWindow windowInto(const SweepGrid& grid, const MaskWindow& window, const PathPiece& piece);

// Elements [lo, hi) of a raster.
struct MaskElements {
    glm::ivec2 lo{0};
    glm::ivec2 hi{0};
};
// The elements of a mask that may come into the grid on a piece of a path, with all corners of their cells.
MaskElements elementsInto(const SweepGrid& grid, const MaskRaster& mask, const PathPiece& piece);

// What of an outline (in steps) may come into the grid on its way along a path. A mask that is made from it,
// of this pitch and filter, is there as one of the whole outline.
Outline outlineInto(const SweepGrid& grid, Outline outline, std::span<const PathPiece> path, double pitch,
                    const MaskFilter& filter);

// The solid that a mask (in steps) sweeps along one piece of a path in the space of steps, as patches in
// voxel space: density 1 inside, its ends exactly at the piece's ends. Nothing for pieces that move the mask
// within its own plane.
SweptPatches sweepPiece(const MaskRaster& mask, const PathPiece& piece, const SweepGrid& grid = {});

// Pieces of a path on which a mask comes into a grid, and the box of voxels that the points are in.
struct SweptWay {
    std::vector<PathPiece> pieces;
    std::vector<Box3> boxes; // of the points of each piece
    Box3 points;             // of all of them
};
// Throws Error for what passes every voxel of the grid, of `dims` voxels, over and over.
SweptWay wayInto(const SweepGrid& grid, glm::ivec3 dims, const MaskRaster& mask,
                 std::span<const PathPiece> path);
// Radiates the mask along such a way, as far as it comes `within` a box (Radiator::begin()).
Box3 sweepWay(Radiator& radiator, PointGenerator& generator, const MaskRaster& mask, const SweptWay& way,
              const SweepGrid& grid, const Box3& within, const Footprint& footprint);

// Radiates a mask (in steps) swept along a path in the space of steps into a volume built from nothing
// (doc/behaviour.md, "Sweeps"). Afterwards `radiator` holds the result. Returns the box of voxels that may
// have energy.
Box3 sweepMask(Radiator& radiator, PointGenerator& generator, const MaskRaster& mask,
               std::span<const PathPiece> path, glm::ivec3 dims, const Footprint& footprint,
               const glm::dvec3& voxelFromSteps = glm::dvec3(1));

} // namespace vs::sculpt

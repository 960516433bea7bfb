// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "sculpt/mask/mask.h"
#include "sculpt/radiation/swept_patches.h"
#include "volume/grid/geometry.h"

#include <span>

namespace vs::sculpt {

// Rasters that are parts of one larger one should begin at multiples of so many of its elements: then their
// samples are the larger one's.
inline constexpr int kMaxBlock = 32;

// Which way each element of a mask moves from its own surface point.
enum class ToolDirection {
    Common,    // drill, laser: one direction for all
    OwnNormal, // peel: against the surface's normal, smoothed over the mask's scale
};

// What a tool sweeps. Depths in steps (the volume's smallest spacing).
struct ToolSweep {
    ToolDirection direction = ToolDirection::Common;
    glm::dvec3 directionWorld{0, 0, 1}; // for Common; of any length but 0
    double depthSteps = 10;
    // One depth for each element, which takes the place of `depthSteps` (0: nothing there).
    std::span<const float> depths = {};
    // The sweep begins this far outside the surface, so that the first layer goes too; negative: the radius.
    double outsideSteps = -1;
    int radius = 3; // of the radiation, in steps: 2, 3 or 4
    // Unit directions (world), one per element, that take the place of `direction`: toolDirections() of it.
    std::span<const glm::vec3> directions = {};
    // For restoring: the sweep goes the other way, from the radius inside the surface to so many steps
    // outside it, one number per element (0: nothing there). See RestoreReach.
    std::span<const float> outwardSteps = {};
    // Whether nothing is swept yet, only noted for SweptPatches::sweepPiece().
    bool inPieces = false;
};

// The direction in which the tool moves from each point: unit vectors (world), from normals that are smoothed
// over the mask's scale.
std::vector<glm::vec3> toolDirections(std::span<const field::SurfacePoint> points, const MaskRaster& mask,
                                      const volume::GridGeometry& geometry, const ToolSweep& sweep);

// The solid that the mask sweeps from the surface points under it (one per mask element, in the same order).
// - Four neighbouring hits span a patch, bilinear in position and direction, so diverging paths leave no
// gaps.
// - Neighbours farther apart than four elements and 3 steps (silhouettes) are not joined: each hit then
// covers its own
//   quarters of the cells around it with straight columns. Where all move the same way, the piece in front
//   goes on beyond its silhouette by the radius (within the mask): its 0.5 level must not end short of it.
// - Nothing is swept outside the grid but what radiates into it, and peeling paths end where they meet, so
// any depth is as good as infinite.
// - Where elements are closer than the samples need to be, blocks of cells become one patch with their mean
// mask.
// - A mask too thin for its radiation to reach 0.5 anywhere gets more energy, so that its strongest place
// reaches 0.6 and
//   it cuts, about as wide as the footprint. An all-zero mask, no hits, or a depth of 0 give nothing.
SweptPatches sweepSurface(std::span<const field::SurfacePoint> points, const MaskRaster& mask,
                          const volume::GridGeometry& geometry, const ToolSweep& sweep);

} // namespace vs::sculpt

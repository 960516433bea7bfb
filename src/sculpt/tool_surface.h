// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "sculpt/mask.h"
#include "sculpt/swept_patches.h"
#include "volume/geometry.h"

#include <span>

namespace vs::sculpt {

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
    // The sweep begins this far outside the surface, so that the first layer goes too; negative: the radius.
    double outsideSteps = -1;
    int radius = 3; // of the radiation, in steps: 2, 3 or 4
    // Nothing is swept yet, only noted for SweptPatches::sweepPiece().
    bool inPieces = false;
};

// The solid that the mask sweeps from the surface points under it (one per mask element, in the same order).
// - Four neighbouring hits span a patch, bilinear in position and direction, so diverging paths leave no
// gaps.
// - Neighbours farther apart than four elements and 3 steps (silhouettes) are not joined: each hit then
// covers its own
//   quarters of the cells around it with straight columns.
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

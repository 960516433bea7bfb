// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"
#include "volume/grid/geometry.h"

#include <limits>

namespace vs::studio {

// How an operation that speaks of the voxels and steps of one grid speaks of those of another one that covers
// the same: another level of a store.
struct OtherGrid {
    glm::dvec3 scale{1}; // voxel v lies at v * scale + offset in the other grid
    glm::dvec3 offset{0};
    double steps = 1;                                 // steps of the other grid in one of its own
    double generations = 1;                           // of growth there in one of growth here
    glm::ivec3 dims{std::numeric_limits<int>::max()}; // voxels of the other grid, where that is known
    // Whether a grid is that of the finest level, at which growth takes place on coarser ones too.
    bool isFromFinest = false;
    bool isToFinest = false;
};
// Throws Error where axes of the grids lie otherwise.
OtherGrid otherGrid(const volume::GridGeometry& from, const volume::GridGeometry& to);

// The operation on the other grid: places, depths, and of growth how far it goes, are what they were in
// millimetres, as nearly as its voxels allow; the radiation's radius, which is one of voxels, stays. Seeds
// that strokes found are looked for again.
Operation onGrid(Operation operation, const OtherGrid& grid);

// Whether it names voxels of the finest level.
bool namesFinest(const Operation& operation);
// The operation where the grid that is worked on is the finest that there is: voxels of the finest level that
// nothing else tells where to find become the ones of that grid that they lie in. `sceneFromFinest`: to that
// grid from that of the finest level.
Operation withoutFinest(Operation operation, const OtherGrid& sceneFromFinest);

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "volume/grid/geometry.h"
#include "volume/grid/volume.h"

#include <vector>

namespace vs::segment {

// A point of a vessel's centreline.
struct VesselPoint {
    glm::dvec3 voxel{0};        // continuous, voxel centres at integers
    double alongMm = 0;         // length of the centreline up to here
    double diameterMm = 0;      // of the circle with the area of the cross-section
    double leastDiameterMm = 0; // the narrowest way through the cross-section's middle
};

// A stretch of a vessel.
struct Vessel {
    std::vector<VesselPoint> points; // about half a step (the smallest spacing) apart, two at least
    double lengthMm = 0;             // of the centreline
};

// Measures the stretch of a vessel between the cross-sections through two voxels, which need not lie on its
// axis. The vessel is a set of voxels in the grid.
//
// Where several ways lead from one voxel to the other, it takes the one on which the sum of length /
// (distance to the wall)^2 is least. Throws Error when a voxel lies farther than 3 voxels from the set, and
// when no way leads from one to the other.
//
// With the scan's values, of the same grid, the wall lies where they pass the middle between what they are
// inside and a little outside of the vessel, to a small fraction of a voxel where they are blurred or tell
// how much of each voxel lies inside. The mask tells it where they show no edge within about half a voxel of
// the mask's wall: where the vessel touches another, or where the mask was edited.
Vessel vesselBetween(const VoxelSet& vessel, const volume::GridGeometry& geometry, glm::ivec3 from,
                     glm::ivec3 to, const volume::Volume* values = nullptr);

} // namespace vs::segment

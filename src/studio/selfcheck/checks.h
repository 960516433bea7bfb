// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/selfcheck/tally.h"

// The checks of stages; self_check.cpp has them in a table.
namespace vs::studio {

// Volumes of every scalar type come back from the device as they were, whole and in part.
void checkUpload(Tally& tally);
// Clears, uploads, dispatches and the sizes of dispatches take effect in the order that they were asked for.
void checkOrder(Tally& tally);
// Values and gradients between voxels, by the texture filter and by quads, trilinear and tricubic, are those
// that are interpolated on the CPU.
void checkSampling(Tally& tally);
// Counts of intensities, of all voxels and of those that a cut leaves, are those of a loop over the voxels.
void checkHistograms(Tally& tally);
// Gradient magnitudes, their largest and their counts are those of central differences on the CPU.
void checkGradients(Tally& tally);
// Smallest and largest values of macrocells are those of the 125 voxels at each cell.
void checkCellRanges(Tally& tally);
// The distance of each macrocell from the nearest one that may show something is the least of those of all
// pairs.
void checkDistances(Tally& tally);
// Values that are smoothed for surfaces are those of a plain convolution.
void checkSmoothing(Tally& tally);
// Colours and opacities that the tables of transfer functions give are those of the functions.
void checkTables(Tally& tally);
// Points spread their energy as Gaussians added up one by one do.
void checkRadiation(Tally& tally);
// A drilled hole is what its mask's values radiate on their whole way; restoring it leaves nothing of it, and
// undo puts back what was there.
void checkDrill(Tally& tally);
// Layers peeled off a ball leave a smaller ball, with the edge that a Gaussian gives it.
void checkPeel(Tally& tally);
// A clip by planes and an outline cut through everything have the edges that their distances say.
void checkSolids(Tally& tally);
// What is seen and belongs to no region is cut, with two voxels around it, and a solid given voxel by voxel
// is united with that.
void checkIslands(Tally& tally);
// Segments grow on the device as on the host, voxel by voxel and generation by generation, by every rule.
void checkGrowth(Tally& tally);
// Places on a surface become the nearest voxels of a range, each once.
void checkSeeds(Tally& tally);
// Segments are smoothed as a Gaussian smooths them, and hold their voxels and no others.
void checkMembership(Tally& tally);
// Rays meet a ball where a formula says, pictures show it there and nowhere else.
void checkSurfaces(Tally& tally);
// Rays meet the face of a cut where its plane lies.
void checkCutFaces(Tally& tally);
// Rays meet a segment's surface where its ball lies.
void checkSegmentSurfaces(Tally& tally);
// What is picked in a maximum intensity projection is a place of the greatest value along its ray.
void checkBrightest(Tally& tally);
// Maximum intensity projections show the greatest of all samples along each ray.
void checkMaximum(Tally& tally);
// X-rays show the sum of all samples along each ray.
void checkXRay(Tally& tally);
// Pictures of volumes are what their samples give when they are composited one after another.
void checkCompositing(Tally& tally);
// Leaving out empty space changes no picture.
void checkSkipping(Tally& tally);
// A part that was cut out and is pasted where it was makes the picture whole again.
void checkParts(Tally& tally);
// A ball blocks as much of the light as it fills, and each level of that is the average of the level before.
void checkLight(Tally& tally);
// Slices show the values that lie in them.
void checkSlices(Tally& tally);
void checkBricks(Tally& tally);
// Colours of marks between their texels are those that are interpolated on the CPU, after each edit.
void checkMarks(Tally& tally);
// How much places are filled, and with which material, is what is interpolated on the CPU, after each edit.
void checkFill(Tally& tally);

} // namespace vs::studio

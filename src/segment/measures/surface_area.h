// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/geometry.h"

#include <array>
#include <cstdint>
#include <span>

namespace vs::segment {

// The surface of each label's voxels in mm^2, by label; 0 where a label does not occur. Background (0) has
// none. What touches the grid's border is closed there.
//
// Every voxel face between inside and outside counts with its area times the cosine between it and the
// surface's normal, which is the gradient of the label's mask smoothed by a Gaussian: Lenoir, Malgouyres and
// Revenu 1996, "Fast computation of the normal vector field of the surface of a 3-D discrete object";
// Coeurjolly, Flin, Teytaud and Tougne 2003, "Multigrid convergence and surface area estimation". Unlike
// Crofton's formula over the 13 directions of a 2x2x2 cell (Lehmann's, in ITK, has weights for cubic voxels
// only) it stays good for flat faces and flat voxels: balls and smooth shapes come out within 1 % on cubic
// voxels and 4 % on voxels three times as high as wide, from a radius of four of them on. Sharp edges are
// rounded over about a voxel: a box of 40 x 30 x 24 voxels loses 3 %.
std::array<double, 256> surfaceAreas(const volume::GridGeometry& geometry,
                                     std::span<const std::uint8_t> labels);

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"
#include "segment/edits/voxel_set.h"
#include "volume/grid/geometry.h"

#include <functional>

namespace vs::mesh {

// Where on the way from a voxel inside (0) to its neighbour outside (1) the surface passes.
using Crossing = std::function<double(glm::ivec3 inside, glm::ivec3 outside)>;

// The surface between a set of voxels of a grid and the rest: marching cubes on voxel centres (Lorensen and
// Cline 1987, by VTK's flying edges, Schroeder, Maynard and Geveci 2015), each point moved along its edge to
// where `crossing` says, but no nearer to a voxel's centre than a hundredth of the way, so that no triangle
// is without area. Where the set reaches the grid's border it is capped by the faces of its outermost voxels.
// Closed, except that parts may touch along an edge; outward, whichever way the grid's axes run. Takes 2
// bytes a voxel of the set's box beside the mesh. `crossing` is called by several threads and must not throw.
Mesh contour(const segment::VoxelSet& set, const volume::GridGeometry& geometry, const Crossing& crossing);

// A set that is not in memory as a whole: what of it lies in a box.
struct Piece {
    segment::VoxelSet set;
    Crossing crossing; // between voxels of the box
};
using PieceOf = std::function<Piece(const Box3& box)>;

// The surface of such a set, which lies in `box`, closed as by contour() and with the same points and
// triangles in another order: pieces of `side` voxels are contoured one by one and joined at their borders.
// Beside the mesh it takes the memory of one piece, and some 50 bytes for each point on a border. `progress`
// is told between pieces.
Mesh contour(const Box3& box, const volume::GridGeometry& geometry, const PieceOf& pieceOf, int side,
             const Progress& progress = {});

} // namespace vs::mesh

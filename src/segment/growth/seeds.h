// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/surface_points.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "segment/growth/constraints.h"

#include <vector>

namespace vs::segment {

// Turns what strokes hit into voxels to grow from. Keep one: it holds compiled shaders and scratch memory.
class SeedFinder {
public:
    // For each surface point, the voxel nearest to it (in mm) that `constraints` admit, among the eight
    // corners of the cell that the point lies in; points without such a corner, and points that met nothing,
    // give none. Each voxel once, sorted by z, then y, then x, so that operation logs do not depend on the
    // device's order.
    std::vector<glm::ivec3> find(const field::SurfacePoints& points, const field::Field& field,
                                 const Constraints& constraints);

private:
    ConstrainedProgram find_{"segment/shaders/find_seeds.comp"};
    gl::Buffer table_;
    gl::Buffer found_;
};

} // namespace vs::segment

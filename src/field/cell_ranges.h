// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "gl/program.h"

namespace vs::field {

// Macrocells of 4^3 voxels. Cell c covers the voxel-space box [4c, 4c + 4] between voxel centres, so what
// trilinear sampling can find in it are the values of its 5^3 corner voxels. The half voxel outside the
// outermost centres belongs to the nearest cell.
inline constexpr int kCell = 4;
glm::ivec3 cellDims(glm::ivec3 dims);

// Smallest and largest value per macrocell (RG32F, values in the field's unit).
struct CellRanges {
    gl::Texture cells;
};

// On the device, or where that is a software renderer and the volume is at hand (Field::onHost), from it.
CellRanges computeCellRanges(const Field& field);
// Such cells of any texture of one value a voxel, as RG32F texels.
gl::Texture computeCellRanges(const gl::Texture& texels);

// Keeps smallest and largest texel per macrocell of a single-channel texture that changes (the sculpture).
class CellRangeUpdater {
public:
    CellRangeUpdater();
    // Writes the ranges of the cells that `voxels` touches into `cells`, which must have cellDims(dims) RG32F
    // texels.
    void update(const gl::Texture& texels, const Box3& voxels, gl::Texture& cells);

private:
    gl::Program program_;
};

} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <string>

namespace vs::volume {

// Where a grid of voxels lies in the patient: a full affine from voxel space (continuous indices, voxel
// centres at integers) to world (LPS millimetres). Anisotropic and sheared grids are allowed; singular ones
// are not.
struct GridGeometry {
    glm::ivec3 dims{0};
    glm::dmat4 worldFromVoxel{1.0};

    // Distance in mm between neighbouring voxel centres along each index axis.
    [[nodiscard]] glm::dvec3 spacing() const;
    // The smallest spacing in mm: one step. Tool depths count steps.
    [[nodiscard]] double stepMm() const;
    [[nodiscard]] glm::dmat4 voxelFromWorld() const;
    [[nodiscard]] glm::dvec3 centreWorld() const;
    // Length in mm of the longest diagonal of the grid's box (voxel borders, not centres).
    [[nodiscard]] double diagonalMm() const;
    // Volume of one voxel in mm^3.
    [[nodiscard]] double voxelMm3() const;
    [[nodiscard]] std::size_t voxelCount() const;
    // Three letters naming the patient direction that each index axis runs towards: "LPS", "RAS", "AIL" ...
    // (L left, R right, P posterior, A anterior, S superior, I inferior; nearest axis for oblique grids).
    [[nodiscard]] std::string orientationCode() const;
    [[nodiscard]] Box3 box() const { return {glm::ivec3(0), dims}; }

    bool operator==(const GridGeometry&) const = default;
};

// Axis-aligned grid with its first voxel's centre at the world's origin.
GridGeometry makeGeometry(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1.0));

} // namespace vs::volume

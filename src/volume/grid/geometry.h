// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <string>
#include <string_view>

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
    // Whether its axes are farther from perpendicular than what the floats of headers round: by a cosine of
    // 1e-3, half a voxel over 500.
    [[nodiscard]] bool isSheared() const;
    [[nodiscard]] Box3 box() const { return {glm::ivec3(0), dims}; }

    bool operator==(const GridGeometry&) const = default;
};

// Three letters as orientationCode() gives them: one of L and R, one of P and A, one of S and I.
bool isOrientationCode(std::string_view code);
// The grid with its axes leading towards other sides of the patient, or with other distances between voxel
// centres (mm, above 0). Voxels keep their indices and the grid its centre; an axis that is given another
// side takes the direction of the one that led there or away from there, so that an oblique grid stays as
// oblique. With its own code, or its own spacing, it stays as it is to the last bit.
GridGeometry reoriented(const GridGeometry& grid, std::string_view code);
GridGeometry respaced(const GridGeometry& grid, const glm::dvec3& spacingMm);
// Whether one is the mirror image of the other, whatever else they differ in.
bool areMirrored(const GridGeometry& a, const GridGeometry& b);

// Axis-aligned grid with its first voxel's centre at the world's origin.
GridGeometry makeGeometry(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1.0));

} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <cstdint>
#include <vector>

namespace vs::segment {

// A set of voxels of a grid: a mask on a box. Nothing outside the box is in the set; the default is the empty
// set. Editing functions (islands.h, margins.h, set_algebra.h) take any box and return tight ones.
struct VoxelSet {
    Box3 box;
    std::vector<std::uint8_t> inside; // box.volume() values, x fastest: 1 in the set, 0 not

    [[nodiscard]] bool contains(glm::ivec3 voxel) const;
    [[nodiscard]] std::size_t count() const;
    // Smallest box that holds the set; the default box for the empty set.
    [[nodiscard]] Box3 tightBox() const;
    // The set as a mask on another box: voxels outside of it are lost.
    [[nodiscard]] VoxelSet within(const Box3& other) const;
    // The set in its tight box, grown by `padding` voxels and clipped to the grid.
    [[nodiscard]] VoxelSet cropped(int padding, glm::ivec3 gridDims) const;
    // The set in its tight box.
    [[nodiscard]] VoxelSet tight() const { return within(tightBox()); }

    // Place of a voxel of the box in `inside`.
    [[nodiscard]] std::size_t indexOf(glm::ivec3 voxel) const;
    [[nodiscard]] glm::ivec3 voxelAt(std::size_t index) const;
};

// A set on `box` that no voxel is in yet.
VoxelSet emptySet(const Box3& box);

// Whether both hold the same voxels, whatever their boxes.
bool operator==(const VoxelSet& a, const VoxelSet& b);

} // namespace vs::segment

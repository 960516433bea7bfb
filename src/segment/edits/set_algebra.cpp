// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/set_algebra.h"

#include <algorithm>
#include <functional>

namespace vs::segment {
namespace {

// Puts both sets on `box`, which holds every voxel of the result, and combines them voxel by voxel.
template <typename Combine>
VoxelSet combine(const VoxelSet& a, const VoxelSet& b, const Box3& box, Combine f) {
    VoxelSet result = a.within(box);
    const VoxelSet other = b.within(box);
    std::transform(result.inside.begin(), result.inside.end(), other.inside.begin(), result.inside.begin(),
                   f);
    return result.tight();
}

} // namespace

VoxelSet unite(const VoxelSet& a, const VoxelSet& b) {
    return combine(a, b, vs::unite(a.box, b.box), std::bit_or<std::uint8_t>());
}

VoxelSet subtract(const VoxelSet& a, const VoxelSet& b) {
    return combine(a, b, a.box, std::greater<std::uint8_t>());
}

VoxelSet intersect(const VoxelSet& a, const VoxelSet& b) {
    return combine(a, b, vs::intersect(a.box, b.box), std::bit_and<std::uint8_t>());
}

} // namespace vs::segment

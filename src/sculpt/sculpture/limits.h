// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "field/bricks/brick_grid.h"
#include "gl/texture.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace vs::sculpt {

// Where tools may work, by the memberships of segments (0.5 at their surfaces): r of what is spared, g of
// what alone is taken. A voxel gets no more of a tool's energy than 1 - r and, where only some is taken, g.
// So the faces of a cut lie on those surfaces, and a voxel of what is spared (r at least 0.5) is never cut.
struct Limits {
    // Memberships in a box of voxels, r and g of each, a byte for both, x fastest. Nothing: both are 0
    // throughout.
    using InBox = std::function<std::vector<std::byte>(const Box3&)>;

    const gl::Texture* memberships = nullptr; // on the sculpture's grid; null: tools may work everywhere
    bool takesOnly = false;
    // On the grid of the finer sculpture, where there is one.
    std::shared_ptr<const InBox> finest = {};
};

// Such memberships where those of a coarser grid are all that is known: what is between its voxels counts.
// `finest` lies in the coarser one's voxel space.
std::shared_ptr<const Limits::InBox> betweenVoxels(const gl::Texture& memberships,
                                                   const field::BrickGrid& finest);

// The greatest energy that a tool may give to each voxel of a box (x fastest); empty: 1 everywhere.
std::vector<float> mostEnergies(const Limits& limits, const Box3& box);
// How many voxels of a box of the finer sculpture a tool may give all its energy to, as far as that is known
// without looking at each.
enum class Allowed { All, Some, None };
Allowed allowedAtFinest(const Limits& limits, const Box3& box);
// mostEnergies() of a box of the finer sculpture's voxels.
std::vector<float> mostEnergiesAtFinest(const Limits& limits, const Box3& box);

} // namespace vs::sculpt

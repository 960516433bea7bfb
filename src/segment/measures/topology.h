// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <array>
#include <cstdint>
#include <span>

namespace vs::segment {

// How a label's voxels hang together, each taken as a solid block with its border: blocks that share a face,
// an edge or a corner are connected (26 neighbours), what is outside only across faces (6). Outside the grid
// is outside.
struct Topology {
    std::int64_t euler = 0;    // parts - tunnels + cavities
    std::int64_t parts = 0;    // pieces that do not touch one another
    std::int64_t cavities = 0; // hollows that are closed all around
    // Ways through, as a ring has one.
    [[nodiscard]] std::int64_t tunnels() const { return parts + cavities - euler; }

    bool operator==(const Topology&) const = default;
};

// Each label's but 0's, zeros where it does not occur. `labels` x fastest; `boxes` as labelBoxes() finds
// them. The Euler number is vertices - edges + faces - blocks of the union, counted once over all voxels
// (Serra 1982: its local configurations of 2 x 2 x 2 voxels); parts and cavities are islands in each label's
// box.
std::array<Topology, 256> topologies(glm::ivec3 dims, std::span<const std::uint8_t> labels,
                                     const std::array<Box3, 256>& boxes);

} // namespace vs::segment

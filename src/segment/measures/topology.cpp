// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/topology.h"

#include "base/check.h"
#include "base/parallel.h"
#include "segment/edits/islands.h"
#include "segment/edits/label_sets.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace vs::segment {
namespace {

// What the eight blocks around a grid corner add to eight times the Euler number: the corner belongs to one
// place, its edges to two, its faces to four and the blocks to eight. Bit dx + 2 dy + 4 dz: one is there.
std::array<int, 256> shares() {
    std::array<int, 256> shares{};
    for (unsigned around = 1; around < 256; ++around) {
        // The blocks on one side along an axis.
        const auto onSide = [](int axis, int side) {
            unsigned blocks = 0;
            for (int i = 0; i < 8; ++i) {
                blocks |= unsigned((i >> axis & 1) == side) << i;
            }
            return blocks;
        };
        int share = 8;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                share -= (around & onSide(axis, side)) != 0 ? 4 : 0; // an edge
                for (const int otherSide : {0, 1}) {                 // a face
                    const int other = (axis + 1) % 3;
                    share += (around & onSide(axis, side) & onSide(other, otherSide)) != 0 ? 2 : 0;
                }
            }
        }
        shares[around] = share - std::popcount(around);
    }
    return shares;
}

using Sums = std::array<std::int64_t, 256>;

// Adds what lies around a corner, label by label.
void addCorner(const std::array<std::uint8_t, 8>& around, const std::array<int, 256>& shares, Sums& sums) {
    if (std::all_of(around.begin(), around.end(), [&](std::uint8_t label) { return label == around[0]; })) {
        return; // inside or outside: nothing
    }
    unsigned left = 0xff;
    while (left != 0) {
        const std::uint8_t label = around[std::size_t(std::countr_zero(left))];
        unsigned own = 0;
        for (unsigned i = 0; i < 8; ++i) {
            own |= unsigned(around[i] == label) << i;
        }
        sums[label] += shares[own];
        left &= ~own;
    }
}

// The corners below and above slice z - 1 are in row z; the first and the last row lie on the grid's border.
Sums eulerSums(glm::ivec3 dims, std::span<const std::uint8_t> labels) {
    static const std::array<int, 256> kShares = shares();
    const int rows = dims.z + 1;
    const int parts = std::min(processorCount(), rows);
    std::vector<Sums> sums(std::size_t(parts), Sums{});
    const std::vector<std::uint8_t> outside(std::size_t(dims.x), 0);
    const auto rowOf = [&](int y, int z) {
        const bool isInside = y >= 0 && z >= 0 && y < dims.y && z < dims.z;
        const auto start = (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
        return isInside ? labels.data() + start : outside.data();
    };
    inParallel(parts, [&](int part) {
        Sums& own = sums[std::size_t(part)];
        for (int z = rows * part / parts; z < rows * (part + 1) / parts; ++z) {
            for (int y = 0; y <= dims.y; ++y) {
                const std::array<const std::uint8_t*, 4> four{rowOf(y - 1, z - 1), rowOf(y, z - 1),
                                                              rowOf(y - 1, z), rowOf(y, z)};
                std::array<std::uint8_t, 8> around{};
                for (int x = 0; x <= dims.x; ++x) {
                    for (std::size_t i = 0; i < 4; ++i) {
                        around[2 * i] = around[2 * i + 1];
                        around[2 * i + 1] = x < dims.x ? four[i][x] : std::uint8_t(0);
                    }
                    addCorner(around, kShares, own);
                }
            }
        }
    });
    for (std::size_t part = 1; part < sums.size(); ++part) {
        for (std::size_t label = 0; label < 256; ++label) {
            sums[0][label] += sums[part][label];
        }
    }
    return sums[0];
}

// Pieces of what is not in the set but for the one around it.
std::int64_t cavitiesOf(const VoxelSet& set) {
    VoxelSet outside = set.within(grow(set.box, 1));
    for (auto& value : outside.inside) {
        value = value == 0 ? 1 : 0;
    }
    return std::int64_t(islands(outside, Connectivity::Six).size()) - 1;
}

} // namespace

std::array<Topology, 256> topologies(glm::ivec3 dims, std::span<const std::uint8_t> labels,
                                     const std::array<Box3, 256>& boxes) {
    VS_CHECK_EQ(labels.size(), std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
    const Sums sums = eulerSums(dims, labels);
    std::array<Topology, 256> found{};
    for (std::size_t label = 1; label < 256; ++label) {
        if (boxes[label].isEmpty()) {
            continue;
        }
        const VoxelSet set = setOf(labels, dims, std::uint8_t(label), boxes[label]);
        found[label].euler = sums[label] / 8;
        found[label].parts = std::int64_t(islands(set, Connectivity::TwentySix).size());
        found[label].cavities = cavitiesOf(set);
    }
    return found;
}

} // namespace vs::segment

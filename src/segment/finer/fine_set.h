// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "segment/finer/fine_cells.h"

#include <cstdint>
#include <map>
#include <vector>

namespace vs::segment {

// A set of voxels of a grid of any size: what it takes follows the bricks of 32^3 that have some of them.
class FineSet {
public:
    using Bricks = std::map<std::uint32_t, CellBits>; // by number; some bit of each is set

    explicit FineSet(glm::ivec3 dims) : grid_{dims, field::kBrick} {}

    [[nodiscard]] glm::ivec3 dims() const { return grid_.dims; }
    [[nodiscard]] const Bricks& bricks() const { return bricks_; }
    [[nodiscard]] bool isEmpty() const { return bricks_.empty(); }
    [[nodiscard]] std::uint64_t count() const;
    [[nodiscard]] bool contains(glm::ivec3 voxel) const;
    // The voxels of the grid that a brick is of.
    [[nodiscard]] Box3 boxOf(std::uint32_t brick) const { return grid_.boxOf(grid_.brickAt(int(brick))); }
    // The bricks' box around it.
    [[nodiscard]] Box3 box() const;

    // The set as a mask on a box, x fastest, which may reach beyond the grid: 1 in the set, 0 not.
    [[nodiscard]] std::vector<std::uint8_t> within(const Box3& box) const;
    // Takes in voxels of a part of the grid that such a mask on `box` has; the part lies in the box.
    void add(const Box3& part, const Box3& box, const std::vector<std::uint8_t>& mask);
    // Takes in voxels from `begin` to before `end` of a row along x.
    void addRow(int begin, int end, int y, int z);
    // Takes in those voxels of a brick whose bits are set.
    void add(std::uint32_t brick, const CellBits& bits);

    // Calls f(begin, end, y, z) for each row of voxels along x that lie side by side in a brick.
    template <typename F>
    void forEachRow(F&& f) const {
        for (const auto& [brick, bits] : bricks_) {
            const glm::ivec3 first = boxOf(brick).lo;
            for (int z = 0; z < field::kBrick; ++z) {
                for (int y = 0; y < field::kBrick; ++y) {
                    std::uint32_t row = rowOf(bits, y, z);
                    for (int x = 0; row != 0;) {
                        const int gap = __builtin_ctz(row);
                        row >>= unsigned(gap);
                        const int length = ~row == 0 ? 32 : __builtin_ctz(~row);
                        x += gap;
                        f(first.x + x, first.x + x + length, first.y + y, first.z + z);
                        x += length;
                        row = length == 32 ? 0 : row >> unsigned(length);
                    }
                }
            }
        }
    }

    bool operator==(const FineSet& other) const { return dims() == other.dims() && bricks_ == other.bricks_; }

private:
    // 32 voxels along x of a brick, the first in the lowest bit.
    static std::uint32_t rowOf(const CellBits& bits, int y, int z);
    [[nodiscard]] std::uint32_t brickOf(glm::ivec3 voxel) const {
        return std::uint32_t(grid_.placeOf(voxel / field::kBrick));
    }

    field::BrickGrid grid_;
    Bricks bricks_;
};

// Both sets are of the same grid.
FineSet unite(const FineSet& a, const FineSet& b);
FineSet subtract(const FineSet& a, const FineSet& b);
FineSet intersect(const FineSet& a, const FineSet& b);

} // namespace vs::segment

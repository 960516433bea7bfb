// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "segment/finer/fine_cells.h"

#include <bit>
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

    // Calls f(begin, end, y, z) for each row of voxels along x that lie side by side in a brick, in the order
    // of z, y and x.
    template <typename F>
    void forEachRow(F&& f) const {
        for (auto layer = bricks_.begin(); layer != bricks_.end();) {
            const auto next = firstBeyondLayer(layer->first);
            for (int z = 0; z < field::kBrick; ++z) {
                for (auto line = layer; line != next;) {
                    const auto end = firstBeyondLine(line->first);
                    for (int y = 0; y < field::kBrick; ++y) {
                        for (auto brick = line; brick != end; ++brick) {
                            forEachRowOf(*brick, y, z, f);
                        }
                    }
                    line = end;
                }
            }
            layer = next;
        }
    }

    bool operator==(const FineSet& other) const { return dims() == other.dims() && bricks_ == other.bricks_; }

private:
    // The first brick beyond the line along x that a brick is in, or beyond its layer along z.
    [[nodiscard]] Bricks::const_iterator firstBeyondLine(std::uint32_t brick) const {
        const glm::ivec3 at = grid_.brickAt(int(brick));
        return bricks_.lower_bound(std::uint32_t(grid_.placeOf({0, at.y + 1, at.z})));
    }
    [[nodiscard]] Bricks::const_iterator firstBeyondLayer(std::uint32_t brick) const {
        return bricks_.lower_bound(std::uint32_t(grid_.placeOf({0, 0, grid_.brickAt(int(brick)).z + 1})));
    }
    template <typename F>
    void forEachRowOf(const Bricks::value_type& brick, int y, int z, F& f) const {
        const glm::ivec3 first = boxOf(brick.first).lo;
        std::uint32_t row = rowOf(brick.second, y, z);
        for (int x = 0; row != 0;) {
            const int gap = std::countr_zero(row);
            row >>= unsigned(gap);
            const int length = std::countr_one(row);
            x += gap;
            f(first.x + x, first.x + x + length, first.y + y, first.z + z);
            x += length;
            row = length == 32 ? 0 : row >> unsigned(length);
        }
    }
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

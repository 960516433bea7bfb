// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "segment/growth/brick_table.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <variant>
#include <vector>

namespace vs::segment {

inline constexpr std::size_t kBrickVoxels = std::size_t(field::kBrick) * field::kBrick * field::kBrick;

// Where a voxel of a brick of 32^3 stands in lists of all of them: tile by tile of 8^3, x fastest in each, as
// growth goes through them.
constexpr std::size_t cellOf(glm::ivec3 inBrick) {
    return std::size_t((inBrick.x >> 3) | (inBrick.y >> 3) << 2 | (inBrick.z >> 3) << 4) << 9U |
           std::size_t((inBrick.x & 7) | (inBrick.y & 7) << 3 | (inBrick.z & 7) << 6);
}
constexpr glm::ivec3 voxelOfCell(std::size_t cell) {
    const auto tile = int(cell >> 9U);
    const auto place = int(cell & 511U);
    return {(tile & 3) << 3 | (place & 7), (tile >> 2 & 3) << 3 | (place >> 3 & 7),
            (tile >> 4) << 3 | place >> 6};
}

// What has grown in a brick, while it changes: of each voxel its generation (0: none) and its segment.
struct OpenCells {
    std::vector<std::uint32_t> generations = std::vector<std::uint32_t>(kBrickVoxels);
    std::vector<std::uint8_t> labels = std::vector<std::uint8_t>(kBrickVoxels);
};

// What has grown in a brick, as it is kept: it never changes. Generations that lie next to one another, as
// those in a brick do, take a byte a voxel, and labels take one byte in all where there is but one.
class FineCells {
public:
    explicit FineCells(const OpenCells& open);

    [[nodiscard]] bool isEmpty() const { return spans_.empty(); }
    [[nodiscard]] std::uint32_t generation(std::size_t cell) const {
        return std::visit(
            [&](const auto& entries) {
                const std::uint32_t entry = entries[cell];
                return entry == 0 ? 0U : base_ + entry;
            },
            entries_);
    }
    // The segment of a voxel that has grown.
    [[nodiscard]] std::uint8_t label(std::size_t cell) const {
        return labels_[labels_.size() == 1 ? 0 : cell];
    }
    // Calls f(cell, generation) for each voxel that has grown.
    template <typename F>
    void forEachGrown(F&& f) const {
        std::visit(
            [&](const auto& entries) {
                for (std::size_t cell = 0; cell < entries.size(); ++cell) {
                    if (entries[cell] != 0) {
                        f(cell, base_ + entries[cell]);
                    }
                }
            },
            entries_);
    }
    // Calls f(entries, base): a voxel's generation is base + its entry, and 0 where that is 0.
    template <typename F>
    void visitEntries(F&& f) const {
        std::visit([&](const auto& entries) { f(entries, base_); }, entries_);
    }
    // The generations of each segment that has voxels here.
    [[nodiscard]] const std::map<std::uint8_t, GenerationSpan>& spans() const { return spans_; }
    [[nodiscard]] bool holds(std::uint8_t label, int after) const {
        const auto found = spans_.find(label);
        return found != spans_.end() && int(found->second.last) > after;
    }
    [[nodiscard]] OpenCells opened() const;
    [[nodiscard]] std::size_t bytes() const;

private:
    std::uint32_t base_ = 0; // generation = this + entry
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<std::uint32_t>> entries_;
    std::vector<std::uint8_t> labels_;
    std::map<std::uint8_t, GenerationSpan> spans_;
};

using FineCellsPtr = std::shared_ptr<const FineCells>;           // null: nothing has grown
using FineMap = std::unordered_map<std::uint32_t, FineCellsPtr>; // by number of the brick; never null

// A bit for each voxel of a brick, in the order of cellOf().
using CellBits = std::array<std::uint64_t, kBrickVoxels / 64>;
inline bool has(const CellBits& bits, std::size_t cell) { return (bits[cell / 64] >> cell % 64 & 1U) != 0; }
inline void set(CellBits& bits, std::size_t cell) { bits[cell / 64] |= std::uint64_t(1) << cell % 64; }

} // namespace vs::segment

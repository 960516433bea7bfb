// SPDX-License-Identifier: Apache-2.0
// Segments at the finest level as sets of voxels: taken out, and put back in another shape.
#include "segment/finer/fine_growth.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <limits>

namespace vs::segment {

namespace {

// The edits that take voxels away from the segment at work and give it others.
std::vector<FineGrowth::BrickEdit> editsOf(const FineSet& taken, const FineSet& given) {
    std::map<std::uint32_t, FineGrowth::BrickEdit> edits;
    for (const auto& [brick, bits] : taken.bricks()) {
        edits[brick].taken = bits;
    }
    for (const auto& [brick, bits] : given.bricks()) {
        edits[brick].given = bits;
    }
    std::vector<FineGrowth::BrickEdit> list;
    list.reserve(edits.size());
    for (auto& [brick, edit] : edits) {
        edit.brick = brick;
        list.push_back(edit);
    }
    return list;
}

} // namespace

FineSet FineGrowth::voxels(std::uint8_t label) const {
    FineSet set(dims());
    const std::uint32_t last =
        label == label_ ? std::uint32_t(run_.state.playhead) : std::numeric_limits<std::uint32_t>::max();
    for (const auto& entry : map_) {
        const FineCells& cells = *entry.second;
        if (!cells.holds(label, 0)) {
            continue;
        }
        CellBits bits{};
        cells.forEachGrown([&](std::size_t cell, std::uint32_t generation) {
            if (generation <= last && cells.label(cell) == label) {
                segment::set(bits, cell);
            }
        });
        set.add(entry.first, bits);
    }
    return set;
}

void FineGrowth::replace(const FineSet& set, FineUndo* undo) {
    const FineSet before = voxels(label_);
    edit(editsOf(subtract(before, set), subtract(set, before)), undo);
}

void FineGrowth::paint(const FineSet& set, bool isToAdd, FineUndo* undo) {
    const FineSet none(dims());
    edit(isToAdd ? editsOf(none, set) : editsOf(set, none), undo);
}

FineSet FineGrowth::inRange(const FineSet& set, const Range& range) const {
    FineSet result(dims());
    volume::visitType(values_->type(), [&](const auto* none) {
        for (const auto& entry : set.bricks()) {
            const CellBits& bits = entry.second;
            const Box3 box = set.boxOf(entry.first);
            const Box3 block = values_->blockBox(box.lo);
            const auto values = values_->blockAround(box.lo);
            const auto* here = reinterpret_cast<decltype(none)>(values->data());
            const glm::ivec3 size = block.size();
            CellBits kept{};
            forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t) {
                const std::size_t cell = cellOf(voxel - box.lo);
                const glm::ivec3 at = voxel - block.lo;
                const std::size_t place =
                    (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
                    std::size_t(at.x);
                if (has(bits, cell) && range.contains(double(here[place]))) {
                    segment::set(kept, cell);
                }
            });
            result.add(entry.first, kept);
        }
    });
    return result;
}

} // namespace vs::segment

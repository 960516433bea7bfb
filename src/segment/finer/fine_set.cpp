// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_set.h"

#include <algorithm>
#include <bit>
#include <functional>

namespace vs::segment {

namespace {

// Eight voxels along x lie in a byte: where in its word it begins.
unsigned byteAt(int y) { return unsigned(y & 7) * 8; }
std::size_t wordAt(int tileX, int y, int z) {
    return std::size_t(tileX | (y >> 3) << 2 | (z >> 3) << 4) * 8 + std::size_t(z & 7);
}

// Bits from `begin` to before `end` of 32.
std::uint32_t bitsBetween(int begin, int end) {
    return std::uint32_t((std::uint64_t(1) << unsigned(end)) - (std::uint64_t(1) << unsigned(begin)));
}

void addToRow(CellBits& bits, std::uint32_t row, int y, int z) {
    for (int tile = 0; tile < 4; ++tile) {
        bits[wordAt(tile, y, z)] |= std::uint64_t(row >> unsigned(tile * 8) & 0xffU) << byteAt(y);
    }
}

template <typename Combine>
FineSet combined(const FineSet& a, const FineSet& b, Combine combine) {
    FineSet result(a.dims());
    const CellBits none{};
    const auto add = [&](std::uint32_t brick, const CellBits& ofA, const CellBits& ofB) {
        CellBits bits;
        std::transform(ofA.begin(), ofA.end(), ofB.begin(), bits.begin(), combine);
        result.add(brick, bits);
    };
    for (const auto& [brick, bits] : a.bricks()) {
        const auto other = b.bricks().find(brick);
        add(brick, bits, other == b.bricks().end() ? none : other->second);
    }
    for (const auto& [brick, bits] : b.bricks()) {
        if (!a.bricks().contains(brick)) {
            add(brick, none, bits);
        }
    }
    return result;
}

} // namespace

std::uint32_t FineSet::rowOf(const CellBits& bits, int y, int z) {
    std::uint32_t row = 0;
    for (int tile = 0; tile < 4; ++tile) {
        row |= std::uint32_t(bits[wordAt(tile, y, z)] >> byteAt(y) & 0xffU) << unsigned(tile * 8);
    }
    return row;
}

std::uint64_t FineSet::count() const {
    std::uint64_t voxels = 0;
    for (const auto& [brick, bits] : bricks_) {
        for (const std::uint64_t word : bits) {
            voxels += std::uint64_t(std::popcount(word));
        }
    }
    return voxels;
}

bool FineSet::contains(glm::ivec3 voxel) const {
    if (!glm::all(glm::lessThan(glm::uvec3(voxel), glm::uvec3(dims())))) {
        return false;
    }
    const auto found = bricks_.find(brickOf(voxel));
    return found != bricks_.end() && has(found->second, cellOf(voxel & (field::kBrick - 1)));
}

Box3 FineSet::box() const {
    Box3 around;
    for (const auto& [brick, bits] : bricks_) {
        around = vs::unite(around, boxOf(brick));
    }
    return around;
}

std::vector<std::uint8_t> FineSet::within(const Box3& box) const {
    std::vector<std::uint8_t> mask(box.volume());
    const Box3 inGrid = vs::intersect(box, {glm::ivec3(0), dims()});
    if (inGrid.isEmpty()) {
        return mask;
    }
    const glm::ivec3 size = box.size();
    forEachVoxel(
        {inGrid.lo / field::kBrick, divideUp(inGrid.hi, field::kBrick)}, [&](glm::ivec3 at, std::size_t) {
            const auto found = bricks_.find(std::uint32_t(grid_.placeOf(at)));
            if (found == bricks_.end()) {
                return;
            }
            const Box3 shared = vs::intersect(grid_.boxOf(at), inGrid);
            const glm::ivec3 first = at * field::kBrick;
            for (int z = shared.lo.z; z < shared.hi.z; ++z) {
                for (int y = shared.lo.y; y < shared.hi.y; ++y) {
                    const std::uint32_t row = rowOf(found->second, y - first.y, z - first.z);
                    if (row == 0) {
                        continue;
                    }
                    std::uint8_t* const out = mask.data() + (std::size_t(z - box.lo.z) * std::size_t(size.y) +
                                                             std::size_t(y - box.lo.y)) *
                                                                std::size_t(size.x);
                    for (int x = shared.lo.x; x < shared.hi.x; ++x) {
                        out[x - box.lo.x] = std::uint8_t(row >> unsigned(x - first.x) & 1U);
                    }
                }
            }
        });
    return mask;
}

void FineSet::add(const Box3& part, const Box3& box, const std::vector<std::uint8_t>& mask) {
    const Box3 inGrid = vs::intersect(part, {glm::ivec3(0), dims()});
    const glm::ivec3 size = box.size();
    for (int z = inGrid.lo.z; z < inGrid.hi.z; ++z) {
        for (int y = inGrid.lo.y; y < inGrid.hi.y; ++y) {
            const auto row = mask.begin() + (std::ptrdiff_t(z - box.lo.z) * size.y + (y - box.lo.y)) * size.x;
            const auto end = row + (inGrid.hi.x - box.lo.x);
            for (auto x = row + (inGrid.lo.x - box.lo.x); x != end;) {
                const auto from = std::find_if(x, end, [](std::uint8_t v) { return v != 0; });
                x = std::find(from, end, std::uint8_t(0));
                if (from != x) {
                    addRow(box.lo.x + int(from - row), box.lo.x + int(x - row), y, z);
                }
            }
        }
    }
}

void FineSet::addRow(int begin, int end, int y, int z) {
    while (begin < end) {
        const glm::ivec3 voxel(begin, y, z);
        const int first = begin & ~(field::kBrick - 1);
        const int next = std::min(end, first + field::kBrick);
        addToRow(bricks_[brickOf(voxel)], bitsBetween(begin - first, next - first), y & (field::kBrick - 1),
                 z & (field::kBrick - 1));
        begin = next;
    }
}

void FineSet::add(std::uint32_t brick, const CellBits& bits) {
    if (std::all_of(bits.begin(), bits.end(), [](std::uint64_t word) { return word == 0; })) {
        return;
    }
    CellBits& own = bricks_[brick];
    std::transform(own.begin(), own.end(), bits.begin(), own.begin(), std::bit_or<std::uint64_t>());
}

FineSet unite(const FineSet& a, const FineSet& b) { return combined(a, b, std::bit_or<std::uint64_t>()); }
FineSet subtract(const FineSet& a, const FineSet& b) {
    return combined(a, b, [](std::uint64_t x, std::uint64_t y) { return x & ~y; });
}
FineSet intersect(const FineSet& a, const FineSet& b) {
    return combined(a, b, std::bit_and<std::uint64_t>());
}

} // namespace vs::segment

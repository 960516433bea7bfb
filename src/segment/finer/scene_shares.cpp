// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/scene_shares.h"

#include <algorithm>
#include <array>

namespace vs::segment {

void ShareCounter::count(const Box3& voxels, const Box3& brick, SceneShares& shares) {
    shares.labels.resize(brick.volume());
    shares.halves.resize(brick.volume());
    shares.generations.resize(brick.volume());
    for (int z = voxels.lo.z; z < voxels.hi.z; ++z) {
        for (int y = voxels.lo.y; y < voxels.hi.y; ++y) {
            const auto row = std::ptrdiff_t(indexIn(brick, {voxels.lo.x, y, z}));
            std::fill_n(shares.labels.begin() + row, voxels.size().x, std::uint8_t(0));
            std::fill_n(shares.halves.begin() + row, voxels.size().x, std::uint8_t(0));
        }
    }
    const Box3 inside = edges_.finestIn(voxels);
    layOut(voxels, inside);
    if (isByTiles(voxels, inside)) {
        countTiles(*finest_.map().at(finest_.brickOf(inside.lo)), voxels, brick, shares);
        return;
    }
    forEachVoxel(bricksAround(inside), [&](glm::ivec3 place, std::size_t) {
        const glm::ivec3 lo = place * field::kBrick;
        const auto known = finest_.map().find(finest_.brickOf(lo));
        if (known != finest_.map().end()) {
            collect(*known->second, lo, intersect(inside, {lo, lo + field::kBrick}));
        }
    });
    sort(voxels.volume());
    std::uint32_t first = 0;
    forEachVoxel(voxels, [&](glm::ivec3 voxel, std::size_t place) {
        const std::span<Voxel> own(sorted_.data() + first, sorted_.data() + end_[place]);
        first = end_[place];
        if (own.empty()) {
            return;
        }
        partByLabel(own);
        const std::uint8_t label = own.front().label;
        const auto most = std::size_t(
            std::find_if(own.begin(), own.end(), [&](const Voxel& v) { return v.label != label; }) -
            own.begin());
        const std::size_t half = (edges_.finestIn({voxel, voxel + 1}).volume() + 1) / 2;
        const auto last = own.begin() + std::ptrdiff_t(std::min(half, most)) - 1;
        std::nth_element(own.begin(), last, own.begin() + std::ptrdiff_t(most),
                         [](const Voxel& a, const Voxel& b) { return a.generation < b.generation; });
        put(shares, indexIn(brick, voxel), {label, most >= half, last->generation});
    });
}

void ShareCounter::put(SceneShares& shares, std::size_t at, const Share& share) {
    shares.labels[at] = share.label;
    shares.halves[at] = share.isHalf ? share.label : std::uint8_t(0);
    shares.generations[at] = share.generation;
}

// Whether all that there is lies in one brick, is one segment's and counts, and no voxel of the scene is in
// two of its tiles: as in most scans, whose levels halve one another.
bool ShareCounter::isByTiles(const Box3& voxels, const Box3& inside) const {
    const glm::ivec3 lo = inside.lo / field::kBrick * field::kBrick;
    const auto known = finest_.map().find(finest_.brickOf(lo));
    if (known == finest_.map().end() || known->second->spans().size() != 1 ||
        !(inside == Box3{lo, glm::min(lo + field::kBrick, finest_.dims())})) {
        return false;
    }
    const auto& [label, span] = *known->second->spans().begin();
    bool isAlong = label != finest_.label() || int(span.last) <= upTo_;
    for (int axis = 0; axis < 3; ++axis) {
        for (int v = voxels.lo[axis]; v < voxels.hi[axis]; ++v) {
            isAlong = isAlong && edges_.edge(axis, v) / 8 == (edges_.edge(axis, v + 1) - 1) / 8;
        }
    }
    return isAlong;
}

// Those of such a brick, tile by tile.
void ShareCounter::countTiles(const FineCells& cells, const Box3& voxels, const Box3& brick,
                              SceneShares& shares) {
    const std::uint8_t label = cells.spans().begin()->first;
    cells.visitTiles([&](std::size_t tile, const auto* entries, std::uint32_t base) {
        const glm::ivec3 at = voxelOfCell(tile * kTileVoxels);
        // The scene's voxels that the tile holds, and where the generations of each are listed.
        std::array<std::array<std::uint32_t, 8>, 3> local{};
        std::array<std::uint32_t, 3> from{};
        glm::ivec3 many(1);
        std::uint32_t room = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& along = along_[axis];
            const auto first = std::size_t(at[int(axis)]);
            const auto last = std::min(first + 8, along.size());
            from[axis] = along[first];
            std::uint32_t width = 0; // of the widest
            for (std::size_t n = first, begin = first; n < last; ++n) {
                local[axis][n - first] = along[n] - from[axis];
                begin = along[n] == along[begin] ? begin : n;
                width = std::max(width, std::uint32_t(n - begin + 1));
            }
            many[int(axis)] = int(local[axis][last - first - 1]) + 1;
            room *= width;
        }
        std::array<std::uint32_t, kTileVoxels> count{};
        grown_.resize(std::size_t(many.x * many.y * many.z) * room);
        for (std::uint32_t row = 0; row < kTileVoxels; row += 8) {
            const auto* own = entries + row;
            auto any = own[0];
            for (int x = 1; x < 8; ++x) {
                any |= own[x];
            }
            if (any == 0) {
                continue;
            }
            const std::uint32_t ofRow =
                (local[2][row >> 6U] * std::uint32_t(many.y) + local[1][row >> 3U & 7U]) *
                std::uint32_t(many.x);
            for (std::uint32_t x = 0; x < 8; ++x) {
                if (own[x] != 0) {
                    const std::uint32_t place = ofRow + local[0][x];
                    grown_[place * room + count[place]++] = base + own[x];
                }
            }
        }
        const Box3 held{glm::ivec3(0), many};
        const glm::ivec3 lo = voxels.lo + glm::ivec3(int(from[0]), int(from[1]), int(from[2]));
        forEachVoxel(held, [&](glm::ivec3 in, std::size_t place) {
            const std::size_t grown = count[place];
            if (grown == 0) {
                return;
            }
            const glm::ivec3 voxel = lo + in;
            const std::size_t half = (edges_.finestIn({voxel, voxel + 1}).volume() + 1) / 2;
            std::uint32_t* const own = grown_.data() + place * room;
            std::uint32_t* const last = own + std::min(half, grown) - 1;
            std::nth_element(own, last, own + grown);
            put(shares, indexIn(brick, voxel), {label, grown >= half, *last});
        });
    });
}

// Where the finest voxels of a box lie among the scene's.
void ShareCounter::layOut(const Box3& voxels, const Box3& inside) {
    placed_.clear();
    first_ = inside.lo;
    size_ = glm::uvec3(voxels.size());
    for (int axis = 0; axis < 3; ++axis) {
        auto& along = along_[std::size_t(axis)];
        along.clear();
        for (int v = voxels.lo[axis]; v < voxels.hi[axis]; ++v) {
            const int many = edges_.edge(axis, v + 1) - edges_.edge(axis, v);
            along.insert(along.end(), std::size_t(many), std::uint32_t(v - voxels.lo[axis]));
        }
    }
}

// Notes what has grown in a part of a brick of the finest level whose first voxel is `lo`.
void ShareCounter::collect(const FineCells& cells, glm::ivec3 lo, const Box3& part) {
    const std::uint8_t atWork = finest_.label();
    const auto own = cells.spans().find(atWork);
    const bool countsAll = own == cells.spans().end() || int(own->second.last) <= upTo_;
    const auto note = [&](glm::ivec3 inBrick, std::size_t cell, std::uint32_t generation) {
        const std::uint8_t label = cells.label(cell);
        if (countsAll || label != atWork || int(generation) <= upTo_) {
            const glm::ivec3 at = lo + inBrick - first_;
            const std::uint32_t row = along_[2][std::size_t(at.z)] * size_.y + along_[1][std::size_t(at.y)];
            placed_.push_back({row * size_.x + along_[0][std::size_t(at.x)], {generation, label}});
        }
    };
    const Box3 whole{lo, glm::min(lo + field::kBrick, finest_.dims())};
    if (part == whole) {
        cells.forEachGrown(
            [&](std::size_t cell, std::uint32_t generation) { note(voxelOfCell(cell), cell, generation); });
        return;
    }
    cells.visitGenerations([&](const auto& generationOf) {
        forEachVoxel(part, [&](glm::ivec3 voxel, std::size_t) {
            const std::size_t cell = cellOf(voxel - lo);
            if (const std::uint32_t generation = generationOf(cell); generation != 0) {
                note(voxel - lo, cell, generation);
            }
        });
    });
}

void ShareCounter::sort(std::size_t places) {
    end_.assign(places + 1, 0);
    for (const Placed& one : placed_) {
        ++end_[one.place + 1];
    }
    for (std::size_t n = 0; n < places; ++n) {
        end_[n + 1] += end_[n];
    }
    // Until now the number of a place was where it begins; each that is put there moves it on to its end.
    sorted_.resize(placed_.size());
    for (const Placed& one : placed_) {
        sorted_[end_[one.place]++] = one.voxel;
    }
}

// Puts those of the segment with the most voxels first; of equal ones that with the smallest label.
void ShareCounter::partByLabel(std::span<Voxel> voxels) {
    const std::uint8_t first = voxels.front().label;
    if (std::all_of(voxels.begin(), voxels.end(), [&](const Voxel& v) { return v.label == first; })) {
        return;
    }
    std::array<std::size_t, 256> many{};
    for (const Voxel& voxel : voxels) {
        ++many[voxel.label];
    }
    const auto most = std::uint8_t(std::max_element(many.begin(), many.end()) - many.begin());
    std::partition(voxels.begin(), voxels.end(), [&](const Voxel& v) { return v.label == most; });
}

} // namespace vs::segment

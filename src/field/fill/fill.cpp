// SPDX-License-Identifier: Apache-2.0
#include "field/fill/fill.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vs::field {

namespace {

std::uint16_t stored(float filled) {
    return std::uint16_t(std::lround(std::clamp(filled, 0.0F, 1.0F) * float(kWhollyFilled)));
}

// Changes the voxels of a box, brick by brick: change(brick, index within it, number within the box).
template <typename Change>
Fill changed(const Fill& fill, const Box3& within, bool makesBricks, const Change& change) {
    const Box3 box = intersect(within, {glm::ivec3(0), fill.dims()});
    if (box.isEmpty()) {
        return fill;
    }
    const glm::ivec3 size = within.size();
    std::vector<Fill::Bricks::Entry> entries;
    forEachVoxel({box.lo / kFillBrick, (box.hi - 1) / kFillBrick + 1}, [&](glm::ivec3 at, std::size_t) {
        const std::uint32_t place = fill.placeOf(at);
        const auto old = fill.bricks().at(place);
        if (old == nullptr && !makesBricks) {
            return;
        }
        auto brick = old != nullptr ? std::make_shared<FillBrick>(*old) : std::make_shared<FillBrick>();
        bool isChanged = false;
        forEachVoxel(intersect(fill.boxOf(place), box), [&](glm::ivec3 voxel, std::size_t) {
            const glm::ivec3 there = voxel - within.lo;
            const std::size_t n =
                (std::size_t(there.z) * std::size_t(size.y) + std::size_t(there.y)) * std::size_t(size.x) +
                std::size_t(there.x);
            isChanged = change(*brick, FillBrick::index(voxel - at * kFillBrick), n) || isChanged;
        });
        if (isChanged) {
            const std::uint8_t first = brick->material.front();
            const bool isWhole = first != 0 && *brick == *wholeBrick(first);
            entries.emplace_back(place, isWhole ? wholeBrick(first) : std::move(brick));
        }
    });
    // Bricks of a box come in the order of their places.
    return entries.empty() ? fill : fill.with(std::move(entries));
}

} // namespace

bool FillBrick::isEmpty() const {
    return std::all_of(filled.begin(), filled.end(), [](std::uint16_t part) { return part == 0; });
}

std::shared_ptr<const FillBrick> wholeBrick(std::uint8_t material) {
    static const auto all = [] {
        std::array<std::shared_ptr<const FillBrick>, kMostMaterials + 1> bricks;
        for (std::size_t m = 0; m < bricks.size(); ++m) {
            auto brick = std::make_shared<FillBrick>();
            brick->filled.fill(m == 0 ? std::uint16_t(0) : kWhollyFilled);
            brick->material.fill(std::uint8_t(m));
            bricks[m] = std::move(brick);
        }
        return bricks;
    }();
    return all.at(material);
}

Box3 Fill::filledWithin(const Box3& box) const {
    Box3 all;
    for (const auto& [place, brick] : bricks_.entries()) {
        const Box3 own = boxOf(place);
        if (!intersect(own, box).isEmpty()) {
            all = all.isEmpty() ? own : unite(all, own);
        }
    }
    return all;
}

Fill::Voxel Fill::at(glm::ivec3 voxel) const {
    if (isEmpty()) {
        return {};
    }
    const glm::ivec3 v = glm::clamp(voxel, glm::ivec3(0), dims_ - 1);
    const auto brick = bricks_.at(placeOf(v / kFillBrick));
    if (brick == nullptr) {
        return {};
    }
    const std::size_t i = FillBrick::index(v % kFillBrick);
    return {float(brick->filled[i]) / float(kWhollyFilled), brick->material[i]};
}

std::uint8_t Fill::materialAt(const glm::dvec3& voxel) const {
    if (isEmpty()) {
        return 0;
    }
    const glm::dvec3 q = glm::clamp(voxel, glm::dvec3(0), glm::dvec3(dims_ - 1));
    const glm::ivec3 first(glm::floor(q));
    const glm::dvec3 part = q - glm::dvec3(first);
    double all = 0;
    double most = 0;
    std::uint8_t material = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - part, part, glm::dvec3(offset));
        const Voxel there = at(first + offset);
        const double weight = w.x * w.y * w.z * there.filled;
        all += weight;
        material = weight > most ? there.material : material;
        most = std::max(most, weight);
    }
    return all >= 0.5 ? material : std::uint8_t(0);
}

std::size_t Fill::voxels(std::uint8_t material) const {
    std::size_t count = 0;
    for (const auto& [place, brick] : bricks_.entries()) {
        const glm::ivec3 lo = brickAt(place) * kFillBrick;
        forEachVoxel(boxOf(place), [&, b = brick.get()](glm::ivec3 voxel, std::size_t) {
            const std::size_t i = FillBrick::index(voxel - lo);
            const bool isOfIt = material == 0 || b->material[i] == material;
            count += isOfIt && b->filled[i] >= kHalfFilled ? 1 : 0;
        });
    }
    return count;
}

FillCorners cornersOf(const Fill& fill, std::uint32_t place) {
    constexpr int side = FillCorners::kSide;
    const glm::ivec3 brick = fill.brickAt(place);
    std::array<Fill::Bricks::Brick, 8> around; // by the bits of where they lie: 1 x, 2 y, 4 z
    FillCorners corners;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 there =
            glm::min(brick + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2), fill.brickDims() - 1);
        around[std::size_t(i)] = fill.bricks().at(fill.placeOf(there));
        corners.isEmpty = corners.isEmpty && around[std::size_t(i)] == nullptr;
    }
    if (corners.isEmpty) {
        return corners;
    }
    corners.filled.resize(std::size_t(side) * side * side);
    corners.material.resize(corners.filled.size());
    const glm::ivec3 lo = brick * kFillBrick;
    forEachVoxel({glm::ivec3(0), glm::ivec3(side)}, [&](glm::ivec3 t, std::size_t n) {
        const glm::ivec3 voxel = glm::min(lo + t, fill.dims() - 1);
        const glm::ivec3 beyond = voxel / kFillBrick - brick;
        const FillBrick* from = around[std::size_t(beyond.x + 2 * beyond.y + 4 * beyond.z)].get();
        if (from != nullptr) {
            const std::size_t i = FillBrick::index(voxel % kFillBrick);
            corners.filled[n] = from->filled[i];
            corners.material[n] = from->material[i];
        }
    });
    const auto isAll = [](const auto& values, auto value) {
        return std::all_of(values.begin(), values.end(), [value](auto each) { return each == value; });
    };
    corners.isEmpty = isAll(corners.filled, std::uint16_t(0));
    if (isAll(corners.filled, kWhollyFilled) && isAll(corners.material, corners.material.front())) {
        corners.whole = corners.material.front();
    }
    return corners;
}

std::vector<std::uint32_t> placesWithOtherCorners(const Fill& before, const Fill& now) {
    const Fill& grid = now.isEmpty() ? before : now;
    std::set<std::uint32_t> places;
    for (const std::uint32_t place : changedPlaces(before.bricks(), now.bricks())) {
        const glm::ivec3 brick = grid.brickAt(place);
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 there = brick - glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
            if (glm::all(glm::greaterThanEqual(there, glm::ivec3(0)))) {
                places.insert(grid.placeOf(there));
            }
        }
    }
    return {places.begin(), places.end()};
}

Box3 changedBetween(const Fill& before, const Fill& now) {
    const Fill& grid = now.isEmpty() ? before : now;
    Box3 all;
    for (const std::uint32_t place : changedPlaces(before.bricks(), now.bricks())) {
        const Box3 box = grow(grid.boxOf(place), 1); // what lies between voxels is interpolated
        all = all.isEmpty() ? box : unite(all, box);
    }
    return all.isEmpty() ? all : intersect(all, {glm::ivec3(0), grid.dims()});
}

std::size_t changedVoxels(const Fill& before, const Fill& now) {
    std::size_t count = 0;
    const FillBrick& none = *wholeBrick(0);
    for (const std::uint32_t place : changedPlaces(before.bricks(), now.bricks())) {
        const auto one = before.bricks().at(place);
        const auto other = now.bricks().at(place);
        const FillBrick& a = one != nullptr ? *one : none;
        const FillBrick& b = other != nullptr ? *other : none;
        for (std::size_t i = 0; i < a.filled.size(); ++i) {
            count += a.filled[i] != b.filled[i] || a.material[i] != b.material[i] ? 1 : 0;
        }
    }
    return count;
}

Fill filledBy(const Fill& fill, const Box3& box, const std::vector<float>& energies, std::uint8_t material) {
    return changed(fill, box, true, [&](FillBrick& brick, std::size_t i, std::size_t n) {
        const std::uint16_t energy = stored(energies[n]);
        const std::uint16_t was = brick.filled[i];
        if (energy == 0 || (energy < kHalfFilled && energy <= was)) {
            return false;
        }
        const std::uint8_t of = brick.material[i];
        brick.filled[i] = std::max(was, energy);
        brick.material[i] = material;
        return brick.filled[i] != was || of != material;
    });
}

Fill takenBy(const Fill& fill, const Box3& box, const std::vector<float>& energies) {
    return changed(fill, box, false, [&](FillBrick& brick, std::size_t i, std::size_t n) {
        const std::uint16_t energy = stored(energies[n]);
        const auto rest = std::uint16_t(kWhollyFilled - energy);
        const std::uint16_t most =
            energy >= kHalfFilled ? std::min<std::uint16_t>(rest, kHalfFilled - 1) : rest;
        if (brick.filled[i] <= most) {
            return false;
        }
        brick.filled[i] = most;
        brick.material[i] = most == 0 ? std::uint8_t(0) : brick.material[i];
        return true;
    });
}

Fill without(const Fill& fill, std::uint8_t material) {
    return changed(fill, {glm::ivec3(0), fill.dims()}, false,
                   [&](FillBrick& brick, std::size_t i, std::size_t) {
                       if (brick.material[i] != material) {
                           return false;
                       }
                       brick.filled[i] = 0;
                       brick.material[i] = 0;
                       return true;
                   });
}

} // namespace vs::field

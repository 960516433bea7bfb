// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_values.h"

#include "base/parallel.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace vs::segment {

namespace {

constexpr int kFinest = 0; // of the source's levels

Box3 clamped(const Box3& box, glm::ivec3 dims) {
    return {glm::clamp(box.lo, glm::ivec3(0), dims - 1), glm::clamp(box.hi, glm::ivec3(1), dims)};
}

} // namespace

FineValues::FineValues(std::shared_ptr<const volume::BrickSource> source, const field::Field& scene,
                       const volume::GridGeometry& finest, std::size_t cacheBytes)
    : source_(std::move(source)), cache_(cacheBytes) {
    field_.geometry = finest;
    field_.isIntegral = scene.isIntegral;
    field_.range = scene.range;
    field_.serial = field::nextSerial();
}

field::BrickCache::Values FineValues::block(int place) {
    const field::BrickGrid grid = blocks();
    return cache_.get({kFinest, place},
                      [&] { return source_->read(kFinest, grid.boxOf(grid.brickAt(place))); });
}

void FineValues::fetch(const std::vector<Box3>& boxes) {
    const field::BrickGrid grid = blocks();
    std::set<int> places;
    for (const Box3& box : boxes) {
        const Box3 inside = clamped(box, grid.dims);
        forEachVoxel(Box3{inside.lo / kBlock, (inside.hi - 1) / kBlock + 1},
                     [&](glm::ivec3 at, std::size_t) { places.insert(grid.placeOf(at)); });
    }
    const std::vector<int> all(places.begin(), places.end());
    inParallel(int(all.size()), [&](int n) { static_cast<void>(block(all[std::size_t(n)])); });
}

std::vector<std::byte> FineValues::read(const Box3& box) {
    const field::BrickGrid grid = blocks();
    const std::size_t size = volume::sizeOf(type());
    const glm::ivec3 boxSize = box.size();
    std::vector<std::byte> values(box.volume() * size);
    const auto at = [&](glm::ivec3 voxel) {
        const glm::ivec3 v = voxel - box.lo;
        return values.data() +
               ((std::size_t(v.z) * std::size_t(boxSize.y) + std::size_t(v.y)) * std::size_t(boxSize.x) +
                std::size_t(v.x)) *
                   size;
    };
    const Box3 inside = clamped(box, grid.dims);
    forEachVoxel(Box3{inside.lo / kBlock, (inside.hi - 1) / kBlock + 1}, [&](glm::ivec3 place, std::size_t) {
        const Box3 own = grid.boxOf(place);
        const auto read = block(grid.placeOf(place));
        const Box3 part = intersect(own, inside);
        const glm::ivec3 ownSize = own.size();
        for (int z = part.lo.z; z < part.hi.z; ++z) {
            for (int y = part.lo.y; y < part.hi.y; ++y) {
                const glm::ivec3 from = glm::ivec3(part.lo.x, y, z) - own.lo;
                const std::size_t first =
                    (std::size_t(from.z) * std::size_t(ownSize.y) + std::size_t(from.y)) *
                        std::size_t(ownSize.x) +
                    std::size_t(from.x);
                std::memcpy(at({part.lo.x, y, z}), read->data() + first * size,
                            std::size_t(part.size().x) * size);
            }
        }
    });
    if (!(inside == box)) {
        forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t) {
            const glm::ivec3 nearest = glm::clamp(voxel, inside.lo, inside.hi - 1);
            if (nearest != voxel) {
                std::memcpy(at(voxel), at(nearest), size);
            }
        });
    }
    return values;
}

} // namespace vs::segment

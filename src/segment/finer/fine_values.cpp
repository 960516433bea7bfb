// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_values.h"

#include "volume/grid/visit_type.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <type_traits>
#include <utility>

namespace vs::segment {

namespace {

constexpr int kFinest = 0;                // of the source's levels
constexpr std::size_t kMostWanted = 64;   // blocks to be read ahead
constexpr std::size_t kRemembered = 4096; // that were

Box3 clamped(const Box3& box, glm::ivec3 dims) {
    return {glm::clamp(box.lo, glm::ivec3(0), dims - 1), glm::clamp(box.hi, glm::ivec3(1), dims)};
}

} // namespace

FineValues::FineValues(std::shared_ptr<const volume::BrickSource> source, const field::Field& scene,
                       const volume::GridGeometry& finest, std::size_t cacheBytes, int threads)
    : source_(std::move(source)), blocks_{finest.dims, kBlock}, cache_(cacheBytes) {
    field_.geometry = finest;
    field_.isIntegral = scene.isIntegral;
    // Values of the scene's level are means of this one's: there may be greater and smaller ones here.
    field_.range = volume::visitType(source_->type(), [](const auto* none) {
        using T = std::remove_cv_t<std::remove_pointer_t<decltype(none)>>;
        using Limits = std::numeric_limits<std::conditional_t<std::is_integral_v<T>, T, float>>;
        return Range{double(Limits::lowest()), double(Limits::max())};
    });
    field_.serial = field::nextSerial();
    for (int n = 0; n < threads; ++n) {
        threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
}

FineValues::~FineValues() {
    const std::lock_guard lock(mutex_);
    wanted_.clear();
    for (std::jthread& thread : threads_) {
        thread.request_stop();
    }
}

field::BrickCache::Values FineValues::block(int place) {
    const field::BrickGrid& grid = blocks_;
    return cache_.get({kFinest, place},
                      [&] { return source_->read(kFinest, grid.boxOf(grid.brickAt(place))); });
}

void FineValues::readAhead(const Box3& box) {
    const field::BrickGrid& grid = blocks_;
    const Box3 inside = intersect(box, {glm::ivec3(0), grid.dims});
    if (inside.isEmpty()) {
        return;
    }
    const std::lock_guard lock(mutex_);
    const std::size_t before = wanted_.size();
    if (asked_.size() > kRemembered) { // they may have been let go of since
        asked_.clear();
    }
    forEachVoxel(Box3{inside.lo / kBlock, (inside.hi - 1) / kBlock + 1}, [&](glm::ivec3 at, std::size_t) {
        if (asked_.insert(grid.placeOf(at)).second) {
            wanted_.push_back(grid.placeOf(at));
        }
    });
    if (wanted_.size() == before) {
        return;
    }
    if (wanted_.size() > kMostWanted) { // the front is elsewhere by now
        wanted_.erase(wanted_.begin(), wanted_.end() - std::ptrdiff_t(kMostWanted));
    }
    hasChanged_.notify_all();
}

void FineValues::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (hasChanged_.wait(lock, stop, [this] { return !wanted_.empty(); }) && !stop.stop_requested()) {
        const int place = wanted_.back();
        wanted_.pop_back();
        lock.unlock();
        try {
            static_cast<void>(block(place));
        } catch (const std::exception&) { // who needs it is told
        }
        lock.lock();
    }
}

std::vector<std::byte> FineValues::read(const Box3& box) {
    const field::BrickGrid& grid = blocks_;
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

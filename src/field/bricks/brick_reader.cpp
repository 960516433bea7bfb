// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/brick_reader.h"

#include "field/bricks/non_finite.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

namespace vs::field {

namespace {

constexpr std::size_t kMostDone = 64; // bricks that wait for being taken

// One stored value as a texel of the format that brickTexels() says.
struct AsTexel {
    std::uint8_t operator()(std::uint8_t v) const { return v; }
    std::uint8_t operator()(std::int8_t v) const { return std::uint8_t(int(v) + 128); }
    std::uint16_t operator()(std::uint16_t v) const { return v; }
    std::uint16_t operator()(std::int16_t v) const { return std::uint16_t(int(v) + 32768); }
    template <typename T>
    float operator()(T v) const {
        const float f = float(v);
        return std::isfinite(f) ? f : kNonFinite;
    }
};

// Copies what a brick has into the texels of another that begins `offset` voxels before it.
template <typename T>
void copyInto(std::vector<std::byte>& texels, int side, const std::vector<std::byte>& values,
              const Box3& from, glm::ivec3 origin) {
    using Texel = decltype(AsTexel()(T()));
    auto* out = reinterpret_cast<Texel*>(texels.data());
    const auto* in = reinterpret_cast<const T*>(values.data());
    const Box3 wanted = intersect(from, {origin, origin + side});
    const glm::ivec3 size = from.size();
    for (int z = wanted.lo.z; z < wanted.hi.z; ++z) {
        for (int y = wanted.lo.y; y < wanted.hi.y; ++y) {
            const glm::ivec3 inFrom = glm::ivec3(wanted.lo.x, y, z) - from.lo;
            const glm::ivec3 inTo = glm::ivec3(wanted.lo.x, y, z) - origin;
            const T* row =
                in +
                (std::size_t(inFrom.z) * std::size_t(size.y) + std::size_t(inFrom.y)) * std::size_t(size.x) +
                std::size_t(inFrom.x);
            Texel* to = out +
                        (std::size_t(inTo.z) * std::size_t(side) + std::size_t(inTo.y)) * std::size_t(side) +
                        std::size_t(inTo.x);
            std::transform(row, row + wanted.size().x, to, AsTexel());
        }
    }
}

// Texels that lie beyond the grid are those at its border: `filled` of `side` are there along each axis.
void repeatBorder(std::vector<std::byte>& texels, int side, glm::ivec3 filled, std::size_t texelBytes) {
    const auto n = std::size_t(side);
    const auto at = [&](std::size_t x, std::size_t y, std::size_t z) {
        return texels.data() + ((z * n + y) * n + x) * texelBytes;
    };
    for (std::size_t z = 0; z < std::size_t(filled.z); ++z) {
        for (std::size_t y = 0; y < std::size_t(filled.y); ++y) {
            for (auto x = std::size_t(filled.x); x < n; ++x) {
                std::memcpy(at(x, y, z), at(x - 1, y, z), texelBytes);
            }
        }
        for (auto y = std::size_t(filled.y); y < n; ++y) {
            std::memcpy(at(0, y, z), at(0, y - 1, z), n * texelBytes);
        }
    }
    for (auto z = std::size_t(filled.z); z < n; ++z) {
        std::memcpy(at(0, 0, z), at(0, 0, z - 1), n * n * texelBytes);
    }
}

} // namespace

BrickReader::BrickReader(std::shared_ptr<const volume::BrickSource> source, std::vector<BrickGrid> grids,
                         std::size_t cacheBytes, int threads)
    : source_(std::move(source)), grids_(std::move(grids)), cache_(cacheBytes) {
    for (int n = 0; n < threads; ++n) {
        threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
}

BrickReader::~BrickReader() {
    for (std::jthread& thread : threads_) {
        thread.request_stop();
    }
}

void BrickReader::want(const std::vector<BrickKey>& keys) {
    const std::lock_guard lock(mutex_);
    wanted_.clear();
    for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
        const bool isDone = std::any_of(done_.begin(), done_.end(),
                                        [&](const ReadBrick& brick) { return brick.key == *key; });
        if (!isDone && !inHand_.contains(*key)) {
            wanted_.push_back(*key);
        }
    }
    hasChanged_.notify_all();
}

std::vector<ReadBrick> BrickReader::take(double waitMs) {
    std::unique_lock lock(mutex_);
    hasChanged_.wait_for(lock, std::chrono::duration<double, std::milli>(std::min(waitMs, 3.6e6)),
                         [&] { return !done_.empty() || (wanted_.empty() && inHand_.empty()); });
    hasChanged_.notify_all(); // there is room for more
    return std::exchange(done_, {});
}

std::size_t BrickReader::outstanding() const {
    const std::lock_guard lock(mutex_);
    return wanted_.size() + inHand_.size() + done_.size();
}

void BrickReader::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (true) {
        hasChanged_.wait(lock, stop, [&] { return !wanted_.empty() && done_.size() < kMostDone; });
        if (stop.stop_requested()) {
            return;
        }
        const BrickKey key = wanted_.back();
        wanted_.pop_back();
        inHand_.insert(key);
        lock.unlock();
        ReadBrick brick = read(key);
        lock.lock();
        inHand_.erase(key);
        done_.push_back(std::move(brick));
        hasChanged_.notify_all();
    }
}

ReadBrick BrickReader::read(const BrickKey& key) {
    try {
        ReadBrick brick{key, texelsOf(key), {}, {}};
        brick.ranges =
            rangesOf(brick.texels, grids_[std::size_t(key.level)].side, brickTexels(source_->type()));
        return brick;
    } catch (const std::exception& error) {
        return {key, {}, {}, error.what()};
    }
}

std::vector<std::byte> BrickReader::texelsOf(const BrickKey& key) {
    const BrickGrid& grid = grids_[std::size_t(key.level)];
    const glm::ivec3 brick = grid.brickAt(key.place);
    const glm::ivec3 counts = grid.counts();
    const int side = grid.texels();
    const std::size_t texelBytes = gl::bytesPerTexel(brickTexels(source_->type()).format);
    std::vector<std::byte> texels(std::size_t(side) * std::size_t(side) * std::size_t(side) * texelBytes);
    // Its own voxels, and the first of those behind it along each axis.
    forEachVoxel({glm::ivec3(0), glm::ivec3(2)}, [&](glm::ivec3 step, std::size_t) {
        const glm::ivec3 from = brick + step;
        if (glm::any(glm::greaterThanEqual(from, counts))) {
            return;
        }
        const Box3 box = grid.boxOf(from);
        const auto values =
            cache_.get({key.level, grid.placeOf(from)}, [&] { return source_->read(key.level, box); });
        volume::visitType(source_->type(), [&]<typename T>(const T*) {
            copyInto<T>(texels, side, *values, box, brick * grid.side);
        });
    });
    const glm::ivec3 filled = glm::min(grid.dims - brick * grid.side, glm::ivec3(side));
    repeatBorder(texels, side, filled, texelBytes);
    return texels;
}

} // namespace vs::field

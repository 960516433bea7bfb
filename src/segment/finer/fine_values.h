// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_cache.h"
#include "field/field.h"
#include "volume/grid/brick_source.h"

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <thread>
#include <vector>

namespace vs::segment {

// Values of the finest level of a scan in levels, box by box. What was read last is kept, and what lies
// beside it is read ahead by threads.
class FineValues {
public:
    // `scene` is the level that is worked on, whose range of values is that of all.
    FineValues(std::shared_ptr<const volume::BrickSource> source, const field::Field& scene,
               const volume::GridGeometry& finest, std::size_t cacheBytes, int threads = 2);
    ~FineValues();
    FineValues(const FineValues&) = delete;
    FineValues& operator=(const FineValues&) = delete;

    // What the rules of growth need to know of the level beside its values; it has no texels.
    [[nodiscard]] const field::Field& field() const { return field_; }
    [[nodiscard]] volume::ScalarType type() const { return source_->type(); }
    // Where its voxels lie was corrected.
    void follow(const volume::GridGeometry& finest) { field_.geometry = finest; }

    // The values of a box, x fastest; beyond the grid those at its border. Throws ReadError.
    [[nodiscard]] std::vector<std::byte> read(const Box3& box);
    // The values of the block of 64^3 voxels that a voxel lies in, and its box, x fastest. Throws ReadError.
    [[nodiscard]] field::BrickCache::Values blockAround(glm::ivec3 voxel) {
        return block(blocks_.placeOf(voxel / kBlock));
    }
    [[nodiscard]] Box3 blockBox(glm::ivec3 voxel) const { return blocks_.boxOf(voxel / kBlock); }
    // Values of such a box will be asked for soon, it may be. What cannot be read is told when they are.
    void readAhead(const Box3& box);

private:
    [[nodiscard]] field::BrickCache::Values block(int place);
    void work(const std::stop_token& stop);

    static constexpr int kBlock = 64; // voxels along a side of what is read at once
    std::shared_ptr<const volume::BrickSource> source_;
    field::Field field_;
    const field::BrickGrid blocks_;
    field::BrickCache cache_;
    std::mutex mutex_;
    std::condition_variable_any hasChanged_;
    std::vector<int> wanted_;           // blocks to be read ahead, the next one last
    std::set<int> asked_;               // of late
    std::vector<std::jthread> threads_; // last: they end before all else goes
};

} // namespace vs::segment

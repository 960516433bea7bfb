// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_cache.h"
#include "field/field.h"
#include "volume/grid/brick_source.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace vs::segment {

// Values of the finest level of a scan in levels, box by box. What was read last is kept.
class FineValues {
public:
    // `scene` is the level that is worked on, whose range of values is that of all.
    FineValues(std::shared_ptr<const volume::BrickSource> source, const field::Field& scene,
               const volume::GridGeometry& finest, std::size_t cacheBytes);

    // What the rules of growth need to know of the level beside its values; it has no texels.
    [[nodiscard]] const field::Field& field() const { return field_; }
    [[nodiscard]] volume::ScalarType type() const { return source_->type(); }
    // Where its voxels lie was corrected.
    void follow(const volume::GridGeometry& finest) { field_.geometry = finest; }

    // The values of a box, x fastest; beyond the grid those at its border. Throws ReadError.
    [[nodiscard]] std::vector<std::byte> read(const Box3& box);
    // Has what a box needs read into the cache by several threads at once. Throws ReadError.
    void fetch(const std::vector<Box3>& boxes);

private:
    [[nodiscard]] field::BrickCache::Values block(int place);
    [[nodiscard]] field::BrickGrid blocks() const { return {field_.geometry.dims, kBlock}; }

    static constexpr int kBlock = 64; // voxels along a side of what is read at once
    std::shared_ptr<const volume::BrickSource> source_;
    field::Field field_;
    field::BrickCache cache_;
};

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/seeds.h"

#include "gl/pass.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace vs::segment {

std::vector<glm::ivec3> SeedFinder::find(const field::SurfacePoints& points, const field::Field& field,
                                         const Constraints& constraints) {
    const std::size_t count = std::size_t(points.size.x) * std::size_t(points.size.y);
    if (count == 0) {
        return {};
    }
    const gl::Pass pass("find seeds");
    gl::Program& program = find_.prepare(field, constraints);
    // At most half full, so that probing stays short.
    const std::size_t slots = std::bit_ceil(2 * count);
    table_.reserve(slots * sizeof(std::uint32_t));
    table_.clear(0, slots * sizeof(std::uint32_t));
    found_.reserve((count + 1) * sizeof(std::uint32_t));
    found_.clear(0, sizeof(std::uint32_t));

    points.points.bindStorage(kPointsStorage);
    table_.bindStorage(kTableStorage);
    found_.bindStorage(kFoundStorage);
    program.set("count", int(count))
        .set("tableMask", std::uint32_t(slots - 1))
        .set("worldFromVoxel", glm::mat4(field.geometry.worldFromVoxel));
    program.dispatchOverList(count, gl::Barrier::All); // the sculpture that this reads may be cut next

    auto voxels = found_.read<std::uint32_t>(found_.readValue<std::uint32_t>(), sizeof(std::uint32_t));
    std::sort(voxels.begin(), voxels.end());
    std::vector<glm::ivec3> seeds;
    seeds.reserve(voxels.size());
    const glm::uvec3 dims(field.geometry.dims);
    for (const std::uint32_t v : voxels) {
        seeds.emplace_back(int(v % dims.x), int(v / dims.x % dims.y), int(v / (dims.x * dims.y)));
    }
    return seeds;
}

} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/region_passes.h"

#include "segment/shaders/bindings.h"

namespace vs::segment {

namespace {

RegionPasses::Bricks marked(const RegionPasses::Bricks& bricks, const std::vector<std::uint32_t>& marks) {
    RegionPasses::Bricks some;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        if (marks[i] != 0) {
            some.push_back(bricks[i]);
        }
    }
    return some;
}

} // namespace

gl::Program& RegionPasses::eraser(const SeedMap& seedMap, bool byPlane, bool looks) {
    gl::Defines defines = seedMap.widthDefines();
    if (byPlane) {
        defines.emplace_back("VS_BY_PLANE", "1");
    }
    if (looks) {
        defines.emplace_back("VS_NOTE", "1");
    }
    return erase_.with(defines);
}

void RegionPasses::prepare(gl::Program& program, SeedMap& seedMap, const Owner& owner, const Which& which) {
    seedMap.bind(program);
    seedMap.bindOwner(program, owner);
    (which.plane != nullptr ? *which.plane : seedMap.grown()).bindStorage(kPlaneStorage);
    counts_.bindStorage(kLossesStorage);
    program.set("last", std::uint32_t(which.last)).set("erasesPlane", which.isInPlane ? 1 : 0);
}

RegionPasses::Bricks RegionPasses::holding(SeedMap& seedMap, const Owner& owner, const Which& which,
                                           const Bricks& among) {
    counts_.reserve(among.size() * sizeof(std::uint32_t));
    counts_.clear();
    gl::Program& program = eraser(seedMap, which.plane != nullptr, true);
    prepare(program, seedMap, owner, which);
    seedMap.dispatchOverBricks(program, among, gl::Barrier::All);
    return marked(among, counts_.read<std::uint32_t>(among.size()));
}

std::vector<std::uint32_t> RegionPasses::erase(SeedMap& seedMap, const Owner& owner, const Which& which,
                                               const Bricks& bricks, int extent) {
    const std::size_t generations = std::size_t(extent) + 1;
    counts_.reserve(generations * sizeof(std::uint32_t));
    counts_.clear();
    gl::Program& program = eraser(seedMap, which.plane != nullptr, false);
    prepare(program, seedMap, owner, which);
    seedMap.dispatchOverBricks(program, bricks, gl::Barrier::All);
    return counts_.read<std::uint32_t>(generations);
}

RegionPasses::Bricks RegionPasses::withFree(SeedMap& seedMap, const gl::Buffer& plane, const Bricks& among) {
    gl::Program& program = add_.with({{"VS_NOTE", "1"}});
    counts_.reserve(among.size() * sizeof(std::uint32_t));
    counts_.clear();
    seedMap.bind(program);
    plane.bindStorage(kPlaneStorage);
    counts_.bindStorage(kGainsStorage);
    seedMap.dispatchOverBricks(program, among, gl::Barrier::All);
    return marked(among, counts_.read<std::uint32_t>(among.size()));
}

std::uint32_t RegionPasses::add(SeedMap& seedMap, const gl::Buffer& plane, const Bricks& bricks,
                                int generation) {
    if (generation > SeedMap::kLongest16) {
        seedMap.widen();
    }
    gl::Program& program = add_.with(seedMap.widthDefines());
    counts_.reserve(sizeof(std::uint32_t));
    counts_.clear();
    seedMap.bind(program);
    plane.bindStorage(kPlaneStorage);
    counts_.bindStorage(kGainsStorage);
    program.set("generation", std::uint32_t(generation));
    seedMap.dispatchOverBricks(program, bricks, gl::Barrier::All);
    return counts_.readValue<std::uint32_t>();
}

void RegionPasses::planeOf(SeedMap& seedMap, const Owner& owner, int last, const field::Field& field,
                           const Constraints* constraints, const gl::Buffer* forbidden,
                           const gl::Buffer& plane, const Bricks& bricks) {
    gl::Defines defines = seedMap.widthDefines();
    if (constraints != nullptr) {
        defines.emplace_back("VS_ADMISSIBLE", "1");
    }
    if (forbidden != nullptr) {
        defines.emplace_back("VS_FORBIDDEN", "1");
        forbidden->bindStorage(kForbiddenInPlaneStorage);
    }
    gl::Program& program = constraints != nullptr ? plane_.prepare(field, *constraints, defines)
                                                  : ownPlane_.with(seedMap.widthDefines());
    seedMap.bind(program);
    seedMap.bindOwner(program, owner);
    plane.bindStorage(kMadePlaneStorage);
    program.set("last", std::uint32_t(last));
    // A plane is storage, or the texels of a region that is flooded.
    seedMap.dispatchOverBricks(program, bricks, gl::Barrier::All);
}

void RegionPasses::setBits(SeedMap& seedMap, const gl::Buffer& plane, std::span<const std::uint32_t> voxels,
                           bool isToSet) {
    gl::Program& program = changeBits_.with({});
    seedMap.bind(program);
    seedMap.bindList(voxels);
    plane.bindStorage(kMadePlaneStorage);
    program.set("count", int(voxels.size())).set("isToSet", isToSet ? 1 : 0);
    program.dispatchOverList(voxels.size(), gl::Barrier::All);
}

void RegionPasses::join(SeedMap& seedMap, const gl::Buffer& plane, const gl::Buffer& added) {
    gl::Program& program = join_.with({});
    const std::size_t words = seedMap.planeBytes() / sizeof(std::uint32_t);
    added.bindStorage(kAddedStorage);
    plane.bindStorage(kMadePlaneStorage);
    program.set("count", int(words));
    program.dispatchOverList(words, gl::Barrier::All);
}

} // namespace vs::segment

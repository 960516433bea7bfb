// SPDX-License-Identifier: Apache-2.0
#include "sculpt/solids/island_cut.h"

#include "base/check.h"
#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

#include <array>

namespace vs::sculpt {

namespace {

constexpr int kWord = 32;       // voxels along x
constexpr int kIslandReach = 2; // voxels cut around an island

} // namespace

Box3 IslandCutter::cut(Sculpture& sculpture, const field::Scene& scene, const gl::Texture& region,
                       BrickBackup& backup) {
    const glm::ivec3 dims = sculpture.dims();
    VS_CHECK(region.size() == dims);
    if (!bounds_) {
        bounds_ = gl::Buffer(6 * sizeof(int), "island bounds");
    }
    const glm::ivec3 words(divideUp(dims.x, kWord), dims.y, dims.z);
    const std::size_t bytes = Box3{glm::ivec3(0), words}.volume() * sizeof(std::uint32_t);
    islands_.reserve(bytes);
    kept_.reserve(bytes);
    bounds_.write(std::span<const int>(std::array<int, 6>{1 << 30, 1 << 30, 1 << 30, -1, -1, -1}));
    islands_.bindStorage(kIslandsStorage);
    kept_.bindStorage(kKeptStorage);
    bounds_.bindStorage(kIslandBoundsStorage);
    {
        const gl::Pass pass("find islands");
        binding_.bind(scene);
        region.bindImage(kRegionImage, gl::Access::Read);
        gl::Program& program = pack_.with({});
        program.set("words", words);
        program.dispatchOver(words, gl::Barrier::All);
    }
    const auto found = bounds_.read<glm::ivec3>(2);
    if (found[1].x < 0) {
        return {};
    }
    const Box3 box = intersect({found[0] - kIslandReach, found[1] + 1 + kIslandReach}, {glm::ivec3(0), dims});
    backup.protect(box);
    {
        const gl::Pass pass("cut islands");
        sculpture.texels().bindImage(kSculptureImage, gl::Access::ReadWrite);
        gl::Program& program = cut_.with(sculpture.defines());
        sculpture.bindLimits(program);
        program.set("words", words).set("dims", dims);
        program.dispatchOver(words, gl::Barrier::All); // islands, read here, are packed again next time
    }
    sculpture.refresh(box);
    return box;
}

} // namespace vs::sculpt

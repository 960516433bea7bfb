// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "sculpt/solids/island_cut.h"
#include "sculpt/solids/solid_cut.h"

namespace vs::studio {

namespace {

constexpr glm::ivec3 kIslandDims(71, 21, 19); // more than two words of 32 voxels along x

// Whether a voxel of a set lies so many steps away along each axis at most.
bool isNear(const std::vector<std::uint8_t>& inside, glm::ivec3 v, int steps) {
    bool found = false;
    forEachVoxel(
        intersect({v - steps, v + steps + 1}, {glm::ivec3(0), kIslandDims}),
        [&](glm::ivec3 there, std::size_t) { found = found || inside[indexOf(there, kIslandDims)] != 0; });
    return found;
}

} // namespace

void checkIslands(Tally& tally) {
    const auto volume = makeNoise(kIslandDims, volume::ScalarType::Int16, 0, 3000);
    const auto field = field::uploadVolume(volume);
    const Range shown{2985, 3000}; // few enough that what is around them is not everything
    std::vector<std::uint8_t> kept;
    std::vector<std::uint8_t> islands;
    forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t n) {
        kept.push_back(n % 211 == 0 ? 1 : 0);
        islands.push_back(shown.contains(volume.at(v)) && kept.back() == 0 ? 1 : 0);
    });
    gl::Texture region(kIslandDims, gl::Format::R8UI, gl::Filter::Nearest, "self check region");
    region.upload(volume.geometry.box(), std::as_bytes(std::span(kept)));
    sculpt::Sculpture sculpture(kIslandDims);
    sculpt::BrickBackup backup(sculpture.texels());
    field::Scene scene;
    scene.data = &field;
    scene.displayedRange = shown;
    scene.view = field::SculptureView::Whole;
    sculpt::IslandCutter().cut(sculpture, scene, region, backup);
    const auto found = sculpture.values(volume.geometry.box());
    tally.about("voxels cut with islands");
    forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t n) {
        tally.compare(double(found[n]), isNear(islands, v, 2) && !isNear(kept, v, 1) ? 1 : 0);
    });

    // A solid that is given voxel by voxel is united with what has been cut.
    std::vector<float> energies(found.size());
    for (std::size_t n = 0; n < energies.size(); ++n) {
        energies[n] = float(n % 17) / 16;
    }
    sculpt::WholeTarget target(sculpture, &backup);
    sculpt::SolidCutter(volume.geometry).cutValues(target, energies, sculpt::Combine::Cut);
    const auto united = sculpture.values(volume.geometry.box());
    tally.about("values of a united solid");
    for (std::size_t n = 0; n < united.size(); ++n) {
        tally.compare(double(united[n]), double(std::max(found[n], energies[n])), 1.0 / 2048);
    }
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "sculpt/sculpture/brick_backup.h"
#include "sculpt/solids/solid_cut.h"

#include <cmath>
#include <numbers>

namespace vs::studio {

namespace {

constexpr glm::ivec3 kSolidDims(37, 30, 26);
constexpr glm::dvec3 kSolidSpacing(1, 1.3, 0.8);

// The edge that radiation gives a plane: half of it lies a step (sigma, of radius 3) either side.
double energyBehindPlane(double distanceMm) {
    return 0.5 + 0.5 * std::erf(distanceMm / (0.8 * std::numbers::sqrt2));
}

// Compares a sculpture with the energies of a solid whose depth (mm, negative outside) is known.
template <typename Depth>
void compareSolid(Tally& tally, const sculpt::Sculpture& sculpture, const Depth& depth) {
    const auto found = sculpture.values({glm::ivec3(0), kSolidDims});
    forEachVoxel({glm::ivec3(0), kSolidDims}, [&](glm::ivec3 v, std::size_t n) {
        const double expected = energyBehindPlane(depth(glm::dvec3(v) * kSolidSpacing));
        // What is next to nothing is left out, and next to all is all.
        tally.compare(double(found[n]), expected, 5e-3);
    });
}

} // namespace

void checkSolids(Tally& tally) {
    const auto geometry = volume::makeGeometry(kSolidDims, kSolidSpacing);
    sculpt::SolidCutter cutter(geometry);

    const glm::dvec3 tilted = glm::normalize(glm::dvec3(1, 0.4, -0.3));
    const std::vector<glm::dvec4> planes{glm::dvec4(tilted, -19.7), glm::dvec4(0, 0, -1, 6.3)};
    const auto outside = [&](glm::dvec3 world) {
        return std::max(glm::dot(tilted, world) - 19.7, 6.3 - world.z);
    };
    for (const bool cutsInside : {false, true}) {
        sculpt::Sculpture sculpture(kSolidDims);
        sculpt::BrickBackup backup(sculpture.texels());
        sculpt::WholeTarget target(sculpture, &backup);
        cutter.clip(target, {planes, cutsInside}, sculpt::Combine::Cut);
        tally.about(cutsInside ? "a clip of what is inside" : "a clip of what is outside");
        compareSolid(tally, sculpture,
                     [&](glm::dvec3 world) { return cutsInside ? -outside(world) : outside(world); });
    }

    // A circle of 40 pixels, each a quarter of a millimetre wide, looked at along +z.
    sculpt::Extrusion circle;
    circle.outline = sculpt::circleOutline({80, 70}, 40);
    circle.projector.pixelFromWorld = glm::dmat4({4, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    circle.projector.pixelMm = 0.25;
    circle.projector.isOrthographic = true;
    circle.projector.viewport = {160, 160};
    sculpt::Sculpture sculpture(kSolidDims);
    sculpt::BrickBackup backup(sculpture.texels());
    sculpt::WholeTarget target(sculpture, &backup);
    cutter.extrude(target, circle, sculpt::Combine::Cut);
    tally.about("a circle through everything");
    compareSolid(tally, sculpture,
                 [](glm::dvec3 world) { return 10 - glm::length(glm::dvec2(world) - glm::dvec2(20, 17.5)); });
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "field/cell_ranges.h"
#include "render/rays/occlusion.h"

#include <cmath>
#include <numbers>

namespace vs::studio {

namespace {

// One level of the volume that says how much blocks the light.
struct LightLevel {
    glm::ivec3 size{0};
    std::vector<double> parts; // 0 to 1

    // Between texels, from the first one's centre at 0; beyond the outermost ones nothing blocks.
    [[nodiscard]] double at(glm::dvec3 p) const {
        const glm::ivec3 first(glm::floor(p));
        double sum = 0;
        forEachVoxel(intersect({first, first + 2}, {glm::ivec3(0), size}), [&](glm::ivec3 v, std::size_t) {
            const glm::dvec3 w = 1.0 - glm::abs(p - glm::dvec3(v));
            sum += w.x * w.y * w.z * parts[indexOf(v, size)];
        });
        return sum;
    }
};

LightLevel lightLevel(const gl::Texture& texels, int level) {
    LightLevel out{texels.size(level), {}};
    for (const std::byte texel : texels.download({glm::ivec3(0), out.size}, level)) {
        out.parts.push_back(double(texel) / 255);
    }
    return out;
}

// What a texel of the next level holds (average_occlusion.comp): the mean of eight places, and, for 0.6 of
// it, less where neighbours lie behind one another.
double averagedPart(const LightLevel& before, glm::ivec3 texel) {
    std::array<double, 8> parts{};
    double sum = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        const glm::dvec3 side(i & 1U, i >> 1U & 1U, i >> 2U);
        parts[i] = before.at(2.0 * glm::dvec3(texel) - 0.25 + 1.5 * side);
        sum += parts[i];
    }
    double both = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        both += parts[i] * (parts[i ^ 1U] + parts[i ^ 2U] + parts[i ^ 4U]);
    }
    return glm::mix(0.125 * sum, 0.25 * sum - both / 24, 0.6);
}

} // namespace

void checkLight(Tally& tally) {
    constexpr double radius = 13.4;
    const auto volume = phantom::makeBall({40, 36, 34}, {19.2, 17.7, 16.4}, radius, 200, 0, 4);
    const auto field = field::uploadVolume(volume);
    const auto cells = field::computeCellRanges(field);
    render::Macrocells macrocells;
    macrocells.rebuild({.dataCells = &cells.cells, .visibleRange = {100, 255}});
    render::OcclusionVolume::Input input;
    input.scene.data = &field;
    input.scene.displayedRange = {100, 255};
    input.macrocells = &macrocells;
    render::OcclusionVolume occlusion;
    occlusion.rebuild(input);

    LightLevel before = lightLevel(occlusion.texels(), 0);
    const glm::ivec3 block = render::OcclusionVolume::blockSize(volume.geometry);
    double filled = 0;
    for (const double part : before.parts) {
        filled += part * block.x * block.y * block.z;
    }
    const double ball = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
    tally.about("what a ball fills, voxels");
    tally.compare(filled, ball, 0.02 * ball);
    for (int level = 1; level < 4; ++level) {
        const LightLevel next = lightLevel(occlusion.texels(), level);
        tally.about("parts of the light that are blocked");
        forEachVoxel({glm::ivec3(0), next.size}, [&](glm::ivec3 texel, std::size_t n) {
            // They are held as 8 bits.
            tally.compare(next.parts[n], averagedPart(before, texel), 1.5 / 255);
        });
        before = next;
    }
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "reference/radiation.h"
#include "sculpt/radiation/radiation.h"

#include <algorithm>

namespace vs::studio {

namespace {

// Points of a ball whose density falls softly from one a voxel at its centre, some of it outside the grid.
// They are strewn: many at one place between voxels would add up what the fitted taps leave there.
std::vector<glm::vec4> pointsInBall(glm::vec3 centre, float radius) {
    constexpr float pitch = 0.47F;
    const auto steps = int(radius / pitch);
    const auto shifts = placesIn(glm::ivec3(1), 40000);
    std::vector<glm::vec4> points;
    forEachVoxel({glm::ivec3(-steps), glm::ivec3(steps + 1)}, [&](glm::ivec3 v, std::size_t n) {
        const glm::vec3 offset = pitch * (glm::vec3(v) + glm::vec3(shifts[n % shifts.size()]));
        const float part = glm::length(offset) / radius;
        if (part < 1) {
            points.emplace_back(centre + offset, pitch * pitch * pitch * (1 - part * part));
        }
    });
    return points;
}

} // namespace

void checkRadiation(Tally& tally) {
    constexpr glm::ivec3 dims(33, 30, 28);
    const auto points = pointsInBall({14.3F, 12.8F, 4.1F}, 11);
    gl::Buffer buffer(points.size() * sizeof(glm::vec4), "self check points");
    buffer.write(std::span(points));
    sculpt::Radiator radiator;
    for (const int radius : {2, 3, 4}) {
        const auto footprint = sculpt::fitFootprint(radius);
        radiator.begin({glm::ivec3(-12), dims + 12}, dims, footprint);
        radiator.deposit(buffer, points.size());
        radiator.finish();
        const auto found = radiator.download({glm::ivec3(0), dims});
        const auto expected = reference::radiate(points, dims, footprint.sigmaVoxels);
        tally.about("energies, radius " + std::to_string(radius));
        // What the fitted taps leave, most with the narrowest Gaussian.
        tally.compareAll(std::span<const float>(found), std::span<const float>(expected),
                         radius == 2 ? 7e-3 : 2.5e-3);
    }
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "segment/membership/segmentation.h"

#include <cmath>
#include <limits>

namespace vs::studio {

namespace {

constexpr glm::ivec3 kSegmentDims(37, 21, 19);
constexpr glm::dvec3 kSegmentSpacing(1, 1, 2.5); // so that the kernel is narrower along z

// A segment smoothed by a Gaussian of one step that ends at three voxels, and held to the truth: at least
// one half in its voxels and less in others.
std::vector<double> smoothedMembership(const std::vector<std::uint8_t>& inside) {
    std::array<std::array<double, 7>, 3> weights{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (int i = -3; i <= 3; ++i) {
            const double steps = i * kSegmentSpacing[int(axis)];
            sum += weights[axis][std::size_t(i + 3)] = std::exp(-0.5 * steps * steps);
        }
        for (double& weight : weights[axis]) {
            weight /= sum;
        }
    }
    std::vector<double> values;
    forEachVoxel({glm::ivec3(0), kSegmentDims}, [&](glm::ivec3 v, std::size_t n) {
        double value = 0;
        forEachVoxel(intersect({v - 3, v + 4}, {glm::ivec3(0), kSegmentDims}),
                     [&](glm::ivec3 there, std::size_t) {
                         const glm::ivec3 o = there - v + 3;
                         value += inside[indexOf(there, kSegmentDims)] * weights[0][std::size_t(o.x)] *
                                  weights[1][std::size_t(o.y)] * weights[2][std::size_t(o.z)];
                     });
        values.push_back(inside[n] != 0 ? std::max(value, 1 - value) : std::min(value, 1 - value));
    });
    return values;
}

} // namespace

void checkMembership(Tally& tally) {
    const auto volume = makeNoise(kSegmentDims, volume::ScalarType::UInt8, 0, 99, kSegmentSpacing);
    const auto field = field::uploadVolume(volume);
    segment::Growth growth(field, segment::GrowthEngine::Host);
    growth.setConstraints({.range = {0, 55}});
    growth.addSeeds(std::vector<glm::ivec3>{{18, 10, 9}, {1, 1, 1}, {30, 15, 3}, {36, 20, 18}});
    growth.advance(6);
    segment::Segmentation segmentation(volume.geometry);
    segmentation.update(growth);
    // The second update rewrites only what has changed.
    growth.advance(std::numeric_limits<int>::max());
    segmentation.update(growth);
    const auto labels = growth.labels();
    tally.about("smooth memberships");
    const auto found = segmentation.values();
    const auto expected = smoothedMembership(labels);
    // They are held as 8 bits.
    tally.compareAll(std::span<const float>(found), std::span<const double>(expected), 0.6 / 255);

    growth.takeBack(4);
    segmentation.update(growth, segment::Smoothing::Plain);
    const auto plain = segmentation.values();
    const auto fewer = growth.labels();
    tally.about("which voxels are shown inside a segment");
    for (std::size_t n = 0; n < plain.size(); ++n) {
        tally.compare(plain[n] >= 0.5F ? 1 : 0, fewer[n]);
    }
}

} // namespace vs::studio

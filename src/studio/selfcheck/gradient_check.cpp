// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "field/gradient.h"
#include "reference/gradient.h"

#include <cmath>
#include <cstdlib>

namespace vs::studio {

namespace {

// The magnitudes that are kept for functions of gradients, at every voxel.
void checkKeptGradients(Tally& tally, const field::Field& field, const std::vector<double>& expected) {
    const double usual = field::gradientRange(field).hi;
    const auto kept = field::computeGradients(field, usual);
    const std::size_t pitch = kept.quads ? 4 : 1;
    const auto texels = kept.quads ? kept.quads.buffer().read<std::uint16_t>(4 * expected.size())
                                   : kept.texels.downloadAll<std::uint16_t>();
    tally.about("magnitudes that are kept, parts of the usual");
    tally.compare(double(texels.size()), double(pitch * expected.size()));
    for (std::size_t n = 0; n < expected.size() && pitch * n < texels.size(); ++n) {
        // They are held as 16 bits.
        const double value = kept.most * texels[n * pitch] / 65535;
        tally.compare(value / usual, std::min(expected[n], kept.most) / usual,
                      kept.most / usual / 65535 + 1e-4);
    }
}

// How many voxels stand in other bins than on the CPU.
void checkGradientCounts(Tally& tally, const field::Field& field, const std::vector<double>& magnitudes) {
    constexpr int bins = 32;
    const Range gradients{0, 0.7 * field::fullGradientRange(field).hi};
    std::vector<std::uint32_t> expected(bins);
    for (const double magnitude : magnitudes) {
        if (magnitude <= gradients.hi) {
            ++expected[std::size_t(std::min(int(magnitude / gradients.hi * bins), bins - 1))];
        }
    }
    const auto found = field::gradientHistogram(field, gradients, bins);
    const auto joint = field::jointHistogram(field, gradients, {41, bins});
    std::int64_t moved = 0;
    std::int64_t movedJoint = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        std::int64_t ofRow = 0;
        for (std::size_t k = 0; k < 41; ++k) {
            ofRow += joint.counts[i * 41 + k];
        }
        moved += std::abs(std::int64_t(found[i]) - std::int64_t(expected[i]));
        movedJoint += std::abs(ofRow - std::int64_t(expected[i]));
    }
    // At a bin's border single precision may fall to either side.
    tally.about("voxels in other bins of gradients");
    tally.compare(double(moved), 0, 8);
    tally.about("voxels in other bins of both");
    tally.compare(double(movedJoint), 0, 8);
}

} // namespace

void checkGradients(Tally& tally) {
    using enum volume::ScalarType;
    for (const auto type : {UInt8, Int16, Float32}) {
        auto volume = makeNoise({37, 21, 19}, type, 0, 200);
        turnOblique(volume);
        const auto field = field::uploadVolume(volume);
        const auto expected = reference::gradientMagnitudes(volume);
        const double largest = *std::max_element(expected.begin(), expected.end());
        tally.about("largest magnitudes");
        tally.compare(field::fullGradientRange(field).hi, largest, 1e-5 * largest);
        checkKeptGradients(tally, field, expected);
        checkGradientCounts(tally, field, expected);
    }
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "field/smoothed_field.h"
#include "reference/convolution.h"

#include <cmath>
#include <limits>

namespace vs::studio {

namespace {

std::vector<double> smoothedValues(const field::Field& field) {
    std::vector<double> values;
    if (field.texels.format() == gl::Format::R16) {
        for (const std::uint16_t texel : field.texels.downloadAll<std::uint16_t>()) {
            values.push_back(texel / 65535.0 * double(field.valueScale) + double(field.valueOffset));
        }
    } else {
        for (const float texel : field.texels.downloadAll<float>()) {
            values.push_back(double(texel));
        }
    }
    return values;
}

void checkSmoothed(Tally& tally, const volume::Volume& volume, double sigma, double allowed) {
    const auto smoothed = field::smoothField(field::uploadVolume(volume), sigma);
    const auto found = smoothedValues(smoothed.field);
    const auto expected = reference::convolved(volume, sigma);
    tally.about(std::string("smoothed values of ") + name(volume.type));
    tally.compare(double(found.size()), double(expected.size()));
    for (std::size_t n = 0; n < std::min(found.size(), expected.size()); ++n) {
        if (std::isfinite(expected[n])) {
            tally.compare(found[n], expected[n], allowed);
        } else {
            tally.require(found[n] < -1e29); // outside every range, as before
        }
    }
}

} // namespace

void checkSmoothing(Tally& tally) {
    constexpr glm::ivec3 dims(27, 19, 33);
    constexpr glm::dvec3 spacing(1, 1.25, 2);
    // Half a step of 65,535 over the range of the values, and sums in single precision.
    checkSmoothed(tally, makeNoise(dims, volume::ScalarType::Int16, 0, 4000, spacing), 1, 0.05);
    auto holed = makeNoise(dims, volume::ScalarType::Float32, 0, 4000, spacing);
    for (std::size_t n = 0; n < holed.geometry.voxelCount(); n += 97) {
        reinterpret_cast<float*>(holed.bytes.data())[n] = std::numeric_limits<float>::quiet_NaN();
    }
    volume::computeRange(holed);
    checkSmoothed(tally, holed, 1.5, 0.005);
}

} // namespace vs::studio

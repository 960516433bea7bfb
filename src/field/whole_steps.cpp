// SPDX-License-Identifier: Apache-2.0
#include "field/whole_steps.h"

#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace vs::field {

namespace {

constexpr double kMostSteps = 65536;
// Steps are at least so many times what floats of that size can tell apart.
constexpr double kLeastStep = 16.0 * std::numeric_limits<float>::epsilon();

bool areWhole(const float* values, std::size_t count, const WholeSteps& steps) {
    return std::all_of(values, values + count, [&](float value) {
        const double stored = std::round((double(value) - steps.intercept) / steps.slope);
        return float(steps.slope * stored + steps.intercept) == value;
    });
}

} // namespace

std::optional<WholeSteps> wholeStepsOf(const volume::Volume& volume) {
    WholeSteps steps{volume.details.slope, volume.details.intercept};
    const bool isScaled = steps.slope != 1 || steps.intercept != 0;
    const double largest = std::max(std::abs(volume.range.lo), std::abs(volume.range.hi));
    if (volume.type != volume::ScalarType::Float32 || volume.nonFiniteCount > 0 || !isScaled ||
        !(steps.step() > kLeastStep * largest)) {
        return {};
    }
    steps.lowest = std::round((volume.range.lo - steps.intercept) / steps.slope);
    const double most =
        std::abs(std::round((volume.range.hi - steps.intercept) / steps.slope) - steps.lowest);
    if (!(most < kMostSteps)) {
        return {};
    }
    steps.count = int(most) + 1;
    const auto* values = reinterpret_cast<const float*>(volume.bytes.data());
    const auto slice = std::size_t(volume.geometry.dims.x) * std::size_t(volume.geometry.dims.y);
    std::atomic<bool> isWhole = true;
    inParallel(volume.geometry.dims.z, [&](int z) {
        if (isWhole && !areWhole(values + std::size_t(z) * slice, slice, steps)) {
            isWhole = false;
        }
    });
    return isWhole ? std::optional(steps) : std::nullopt;
}

} // namespace vs::field

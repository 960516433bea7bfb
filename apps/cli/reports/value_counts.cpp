// SPDX-License-Identifier: Apache-2.0
#include "reports/value_counts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

namespace vs::cli {

namespace {

constexpr double kMostSteps = 65536;

std::optional<SteppedValues> stepsOfWhole(const volume::Volume& volume) {
    const auto perValue = countsPerValue(volume);
    std::size_t pitch = 0;
    for (std::size_t i = 0; i < perValue.size(); ++i) {
        pitch = perValue[i] > 0 ? std::gcd(pitch, i) : pitch;
    }
    pitch = std::max<std::size_t>(pitch, 1);
    SteppedValues steps{double(pitch), {}};
    for (std::size_t i = 0; i < perValue.size(); i += pitch) {
        steps.counts.push_back(perValue[i]);
    }
    return steps;
}

// Different values and how often they occur; nothing if there are too many.
std::optional<std::map<double, std::uint64_t>> distinctValues(const volume::Volume& volume) {
    constexpr std::size_t kMostValues = 8192;
    std::unordered_map<double, std::uint64_t> counts;
    volume::visit(volume, [&](const auto* values) {
        for (std::size_t i = 0; i < volume.geometry.voxelCount() && counts.size() <= kMostValues; ++i) {
            if (std::isfinite(double(values[i]))) {
                ++counts[double(values[i])];
            }
        }
    });
    if (counts.size() > kMostValues) {
        return std::nullopt;
    }
    return std::map<double, std::uint64_t>(counts.begin(), counts.end());
}

std::optional<SteppedValues> stepsOfOthers(const volume::Volume& volume) {
    const auto distinct = distinctValues(volume);
    if (!distinct || distinct->size() < 2) {
        return std::nullopt;
    }
    double least = volume.range.width();
    for (auto a = distinct->begin(), b = std::next(a); b != distinct->end(); ++a, ++b) {
        least = std::min(least, b->first - a->first);
    }
    // The smallest distance is rounded as values are; over the whole range that adds up to less.
    const double count = std::round(volume.range.width() / least);
    SteppedValues steps{volume.range.width() / count, {}};
    if (count >= kMostSteps) {
        return std::nullopt;
    }
    steps.counts.resize(std::size_t(count) + 1);
    for (const auto& [value, voxels] : *distinct) {
        const double place = (value - volume.range.lo) / steps.pitch;
        if (std::abs(place - std::round(place)) > 0.05) {
            return std::nullopt;
        }
        steps.counts[std::size_t(std::lround(place))] += voxels;
    }
    return steps;
}

} // namespace

bool hasFewValues(const volume::Volume& volume) {
    return volume.type != volume::ScalarType::Float32 && volume.range.width() < kMostSteps;
}

std::vector<std::uint64_t> countsPerValue(const volume::Volume& volume) {
    std::vector<std::uint64_t> counts(std::size_t(volume.range.width()) + 1);
    volume::visit(volume, [&](const auto* values) {
        const auto lowest = std::int64_t(volume.range.lo);
        for (std::size_t i = 0; i < volume.geometry.voxelCount(); ++i) {
            ++counts[std::size_t(std::int64_t(values[i]) - lowest)];
        }
    });
    return counts;
}

std::optional<SteppedValues> countSteps(const volume::Volume& volume) {
    return hasFewValues(volume) ? stepsOfWhole(volume) : stepsOfOthers(volume);
}

} // namespace vs::cli

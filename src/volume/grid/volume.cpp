// SPDX-License-Identifier: Apache-2.0
#include "volume/grid/volume.h"

#include "base/hash.h"

#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

namespace vs::volume {

const char* name(ScalarType type) {
    constexpr const char* names[] = {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float32"};
    return names[static_cast<int>(type)];
}

std::size_t sizeOf(ScalarType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4};
    return sizes[static_cast<int>(type)];
}

double Volume::at(glm::ivec3 index) const {
    const auto& d = geometry.dims;
    const std::size_t i =
        (std::size_t(index.z) * std::size_t(d.y) + std::size_t(index.y)) * std::size_t(d.x) +
        std::size_t(index.x);
    return visit(*this, [&](const auto* values) { return double(values[i]); });
}

namespace {

template <typename T>
bool isFiniteValue([[maybe_unused]] T value) {
    if constexpr (std::is_floating_point_v<T>) {
        return std::isfinite(value);
    } else {
        return true;
    }
}

} // namespace

void computeRange(Volume& volume) {
    const std::size_t count = volume.geometry.voxelCount();
    visit(volume, [&](const auto* values) {
        using T = std::remove_cv_t<std::remove_pointer_t<decltype(values)>>;
        T lo = std::numeric_limits<T>::max();
        T hi = std::numeric_limits<T>::lowest();
        std::size_t nonFinite = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (!isFiniteValue(values[i])) {
                ++nonFinite;
                continue;
            }
            lo = std::min(lo, values[i]);
            hi = std::max(hi, values[i]);
        }
        volume.nonFiniteCount = nonFinite;
        volume.range = nonFinite == count ? Range{0, 0} : Range{double(lo), double(hi)};
    });
}

std::vector<std::uint64_t> histogram(const Volume& volume, int bins) {
    std::vector<std::uint64_t> counts(std::size_t(bins), 0);
    const double scale = volume.range.width() > 0 ? bins / volume.range.width() : 0.0;
    visit(volume, [&](const auto* values) {
        for (std::size_t i = 0; i < volume.geometry.voxelCount(); ++i) {
            if (isFiniteValue(values[i])) {
                const int bin = int((double(values[i]) - volume.range.lo) * scale);
                ++counts[std::size_t(std::clamp(bin, 0, bins - 1))];
            }
        }
    });
    return counts;
}

double otsuThreshold(std::span<const std::uint64_t> counts, const Range& range) {
    double total = 0;
    double weighted = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        total += double(counts[i]);
        weighted += double(i) * double(counts[i]);
    }
    double below = 0;
    double weightedBelow = 0;
    double bestVariance = -1;
    std::size_t first = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
        below += double(counts[i]);
        weightedBelow += double(i) * double(counts[i]);
        const double above = total - below;
        if (below <= 0 || above <= 0) {
            continue;
        }
        const double meanGap = weightedBelow / below - (weighted - weightedBelow) / above;
        const double variance = below * above * meanGap * meanGap;
        if (variance > bestVariance) {
            bestVariance = variance;
            first = i + 1;
        }
        last = variance >= bestVariance ? i + 1 : last;
    }
    return range.lo + range.width() * 0.5 * double(first + last) / double(counts.size());
}

std::string checksum(const Volume& volume) {
    Hash64 hash;
    for (int axis = 0; axis < 3; ++axis) {
        hash.add(std::uint64_t(volume.geometry.dims[axis]));
    }
    hash.add(std::uint64_t(volume.type));
    hash.add(std::span<const std::byte>(volume.bytes));
    return hash.text();
}

} // namespace vs::volume

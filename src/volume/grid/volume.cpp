// SPDX-License-Identifier: Apache-2.0
#include "volume/grid/volume.h"

#include "base/hash.h"

#include <algorithm>
#include <cmath>
#include <functional>
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

// The so many largest of the values that it is told.
class Largest {
public:
    explicit Largest(std::size_t count) : count_(count) {}

    void add(double value) {
        if (values_.size() == count_ && value <= values_.front()) {
            return;
        }
        if (values_.size() == count_) {
            std::pop_heap(values_.begin(), values_.end(), std::greater<>());
            values_.pop_back();
        }
        values_.push_back(value);
        std::push_heap(values_.begin(), values_.end(), std::greater<>());
    }
    // The smallest of them.
    [[nodiscard]] double least() const { return values_.front(); }
    // The largest that is not above a limit, which least() must not be either.
    [[nodiscard]] double mostUpTo(double limit) const {
        double most = least();
        for (const double value : values_) {
            most = value <= limit ? std::max(most, value) : most;
        }
        return most;
    }

private:
    std::size_t count_;
    std::vector<double> values_;
};

template <typename T>
bool isMeasured(T value) {
    return isFiniteValue(value) && std::abs(double(value)) < kNotMeasured;
}

// Whether a part of the values, taken all over the scan, leaves it possible that some are far away from the
// others.
template <typename T>
bool mayHoldExtremes(std::span<const T> values, const Range& range) {
    // Steps of the golden section of the whole spread evenly and fall in with no row of the scan, as steps of
    // a whole number of voxels may: then all that are looked at lie on one of its faces.
    constexpr std::size_t most = 1 << 14;
    constexpr double golden = 0.6180339887498949;
    std::vector<double> some;
    some.reserve(std::min(most, values.size()));
    double at = 0;
    for (std::size_t n = 0; n < std::min(most, values.size()); ++n, at += golden) {
        const auto i = std::size_t((at - std::floor(at)) * double(values.size()));
        if (isMeasured(values[i])) {
            some.push_back(double(values[i]));
        }
    }
    if (some.size() < 16) {
        return true;
    }
    const std::size_t rim = std::max<std::size_t>(1, some.size() / 1000);
    const auto low = some.begin() + std::ptrdiff_t(rim);
    const auto high = some.end() - 1 - std::ptrdiff_t(rim);
    std::nth_element(some.begin(), low, some.end());
    std::nth_element(low, high, some.end());
    return range.width() > 100 * (*high - *low);
}

// Calls `use(value, count)` for all that are measured: for whole numbers of a byte or two once for each that
// there is.
template <typename T, typename Use>
void forEachValue(std::span<const T> values, const Use& use) {
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
        constexpr int least = std::numeric_limits<T>::lowest();
        std::vector<std::size_t> counts(std::size_t(1) << (8 * sizeof(T)));
        for (const T value : values) {
            ++counts[std::size_t(int(value) - least)];
        }
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (counts[i] > 0) {
                use(double(least + int(i)), counts[i]);
            }
        }
    } else {
        for (const T value : values) {
            if (isMeasured(value)) {
                use(double(value), std::size_t(1));
            }
        }
    }
}

template <typename T>
Range usualRange(std::span<const T> values, const Range& range) {
    if (!mayHoldExtremes(values, range)) {
        return range;
    }
    const std::size_t few = std::max<std::size_t>(1, values.size() / 100000);
    Largest above(few + 1);
    Largest below(few + 1); // of the values' negatives
    std::size_t measured = 0;
    forEachValue(values, [&](double value, std::size_t count) {
        for (std::size_t n = 0; n < std::min(count, few + 1); ++n) {
            above.add(value);
            below.add(-value);
        }
        measured += count;
    });
    if (measured == 0) {
        return range;
    }
    const Range most{-below.least(), above.least()};
    const double far = measured > 2 * few + 1 && most.width() > 0 ? 100 * most.width() : 2 * kNotMeasured;
    return {-below.mostUpTo(far - most.lo), above.mostUpTo(most.hi + far)};
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
        volume.usual = usualRange(std::span(values, count), volume.range);
    });
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

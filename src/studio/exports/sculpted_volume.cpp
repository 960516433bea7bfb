// SPDX-License-Identifier: Apache-2.0
#include "studio/exports/exports.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace vs::studio {

namespace {

// How far a value has gone over to the fill; the sculpture from 0 to 1.
double removedShare(double sculpture, field::SculptureView view) {
    const double cut = 2.0 * sculpture - 1;
    return std::clamp(view == field::SculptureView::Probe ? -cut : cut, 0.0, 1.0);
}

template <typename T>
T valueAs(double value) {
    if constexpr (std::is_floating_point_v<T>) {
        return T(value);
    } else {
        using Limits = std::numeric_limits<T>;
        return T(std::round(std::clamp(value, double(Limits::lowest()), double(Limits::max()))));
    }
}

} // namespace

volume::Volume sculptedVolume(const ExportSource& source, const std::optional<double>& fill) {
    volume::Volume left = *source.volume;
    left.geometry = source.geometry;
    const bool isProbe = source.view == field::SculptureView::Probe;
    if (source.view == field::SculptureView::Whole || (source.sculpture.empty() && !isProbe)) {
        return left;
    }
    const double filled = fill.value_or(left.range.lo);
    volume::visit(*source.volume, [&](const auto* values) {
        using T = std::remove_cvref_t<decltype(*values)>;
        for (std::size_t i = 0; i < left.geometry.voxelCount(); ++i) {
            const double removed =
                source.sculpture.empty() ? 1 : removedShare(source.sculpture[i] / 65535.0, source.view);
            if (removed > 0) {
                const double value(values[i]);
                const T mixed = valueAs<T>(removed == 1 ? filled : value + removed * (filled - value));
                std::memcpy(left.bytes.data() + i * sizeof(T), &mixed, sizeof(T));
            }
        }
    });
    volume::computeRange(left);
    return left;
}

void takeCutAway(std::span<std::byte> values, volume::ScalarType type, std::span<const float> sculpture,
                 field::SculptureView view, double fill) {
    volume::visitType(type, [&]<typename T>(const T*) {
        for (std::size_t i = 0; i < sculpture.size(); ++i) {
            const double removed = removedShare(double(sculpture[i]), view);
            if (removed > 0) {
                T value{};
                std::memcpy(&value, values.data() + i * sizeof(T), sizeof(T));
                const T mixed =
                    valueAs<T>(removed == 1 ? fill : double(value) + removed * (fill - double(value)));
                std::memcpy(values.data() + i * sizeof(T), &mixed, sizeof(T));
            }
        }
    });
}

} // namespace vs::studio

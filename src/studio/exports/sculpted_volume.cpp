// SPDX-License-Identifier: Apache-2.0
#include "studio/exports/exports.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace vs::studio {

namespace {

// How far a value has gone over to the fill.
double removedShare(std::uint16_t sculpture, field::SculptureView view) {
    const double cut = 2.0 * sculpture / 65535.0 - 1;
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
                source.sculpture.empty() ? 1 : removedShare(source.sculpture[i], source.view);
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

} // namespace vs::studio

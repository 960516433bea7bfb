// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/stroke.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

bool isOnWay(const PenPoint& point, const PenPoint& from, const PenPoint& to) {
    constexpr double kWithinPixels = 1; // a mouse's places are rounded to whole ones
    constexpr double kWithinPressure = 0.02;
    constexpr double kWithinDegrees = 1;
    const glm::dvec2 way = to.pixel - from.pixel;
    const double length = std::max(glm::length(way), 1e-9);
    const double along = glm::dot(point.pixel - from.pixel, way) / (length * length);
    const glm::dvec2 nearest = from.pixel + along * way;
    const double pressure = glm::mix(from.pressure, to.pressure, along);
    const glm::dvec2 tilt = glm::mix(from.tiltDegrees, to.tiltDegrees, along);
    return point.pressure > 0 && along >= 0 && along <= 1 &&
           glm::distance(point.pixel, nearest) <= kWithinPixels &&
           std::abs(point.pressure - pressure) <= kWithinPressure &&
           glm::distance(point.tiltDegrees, tilt) <= kWithinDegrees;
}

Stroke straightened(const Stroke& stroke) {
    Stroke kept;
    std::size_t from = 0;
    while (from < stroke.size()) {
        kept.push_back(stroke[from]);
        std::size_t to = from + 1; // the farthest that all between lie on the way to
        const auto reaches = [&](std::size_t end) {
            return std::all_of(stroke.begin() + std::ptrdiff_t(from) + 1,
                               stroke.begin() + std::ptrdiff_t(end),
                               [&](const PenPoint& p) { return isOnWay(p, stroke[from], stroke[end]); });
        };
        while (to + 1 < stroke.size() && reaches(to + 1)) {
            ++to;
        }
        from = to;
    }
    return kept;
}

} // namespace vs::sculpt

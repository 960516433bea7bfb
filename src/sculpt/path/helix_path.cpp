// SPDX-License-Identifier: Apache-2.0
#include "sculpt/path/curve_frames.h"
#include "sculpt/path/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vs::sculpt {

namespace {

// The helix's own axes: x and y across it, z along it.
struct HelixAxes {
    MaskFrame across;
    double angle = 0;     // of all turns
    glm::dvec3 height{0}; // from end to end

    explicit HelixAxes(const Helix& helix)
        : across(
              frameFacing(helix.from, helix.to == helix.from ? glm::dvec3(0, 0, 1) : helix.to - helix.from)),
          angle(2 * std::numbers::pi * helix.turns), height(helix.to - helix.from) {}

    [[nodiscard]] glm::dvec3 outwards(double t) const {
        return std::cos(angle * t) * across.x + std::sin(angle * t) * across.y;
    }
    [[nodiscard]] glm::dvec3 sidewards(double t) const {
        return std::cos(angle * t) * across.y - std::sin(angle * t) * across.x;
    }
};

} // namespace

glm::dvec3 Helix::at(double t) const {
    const HelixAxes axes(*this);
    return from + t * axes.height + radius * axes.outwards(t);
}

std::vector<PathPiece> helixPath(const Helix& helix, FrameKind kind, const PathRegion& region) {
    const HelixAxes axes(helix);
    const double round = helix.radius * axes.angle; // what it goes about the axis
    const double length = std::hypot(round, glm::length(axes.height));
    if (length < 1e-9) {
        return {};
    }
    const double curvature = helix.radius * axes.angle * axes.angle / (length * length);
    const double turn = std::min(kChordTurn, std::sqrt(8 * kChordTolerance / std::max(helix.radius, 1e-9)));
    const int count = std::max(int(std::ceil(std::abs(axes.angle) / turn)), 1);
    const int coarse = std::max(int(kChordTurn / turn), 1); // chords that one may stand for
    std::vector<CurveSample> samples;
    const auto add = [&](int n) {
        const double t = double(n) / count;
        append(samples, {helix.at(t), (axes.height + round * axes.sidewards(t)) / length,
                         -curvature * axes.outwards(t)});
    };
    add(0);
    for (int n = 0; n < count; n += coarse) {
        const int end = std::min(n + coarse, count);
        const double half = 0.5 * (end - n) / count;
        const bool isFine = region.mayHold(helix.at(double(n) / count + half), half * length);
        for (int k = isFine ? n + 1 : end; k <= end; ++k) {
            add(k);
        }
    }
    return framesAlong(samples, kind);
}

} // namespace vs::sculpt

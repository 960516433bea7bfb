// SPDX-License-Identifier: Apache-2.0
#include "sculpt/path/path.h"

#include "sculpt/path/curve_frames.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::sculpt {

namespace {

std::vector<glm::dvec3> withoutRepeats(std::span<const glm::dvec3> points) {
    std::vector<glm::dvec3> out;
    for (const glm::dvec3& point : points) {
        if (out.empty() || glm::length(point - out.back()) > 1e-6) {
            out.push_back(point);
        }
    }
    return out;
}

// A cubic between two points, with the derivatives at its ends by a parameter from 0 to 1.
struct Cubic {
    glm::dvec3 from{0};
    glm::dvec3 to{0};
    glm::dvec3 fromSlope{0};
    glm::dvec3 toSlope{0};

    [[nodiscard]] glm::dvec3 at(double t) const {
        const double s = 1 - t;
        return s * s * (1 + 2 * t) * from + t * t * (1 + 2 * s) * to + t * s * (s * fromSlope - t * toSlope);
    }
    [[nodiscard]] glm::dvec3 slope(double t) const {
        const double s = 1 - t;
        return 6 * t * s * (to - from) + s * (1 - 3 * t) * fromSlope + t * (1 - 3 * s) * toSlope;
    }
    [[nodiscard]] glm::dvec3 bend(double t) const {
        return 6 * (1 - 2 * t) * (to - from) + (6 * t - 4) * fromSlope + (6 * t - 2) * toSlope;
    }
};

// The piece of the centripetal Catmull-Rom spline between the middle two of four points: its derivatives are
// those of the parabolas through three points each, over knots whose distances are the roots of the points'.
Cubic catmullRom(const glm::dvec3& before, const glm::dvec3& from, const glm::dvec3& to,
                 const glm::dvec3& after) {
    const double a = std::sqrt(glm::length(from - before));
    const double b = std::sqrt(glm::length(to - from));
    const double c = std::sqrt(glm::length(after - to));
    const glm::dvec3 fromSlope = (from - before) / a - (to - before) / (a + b) + (to - from) / b;
    const glm::dvec3 toSlope = (to - from) / b - (after - from) / (b + c) + (after - to) / c;
    return {from, to, b * fromSlope, b * toSlope};
}

CurveSample sampleAt(const Cubic& cubic, double t) {
    // Where the way turns straight back the slope vanishes: there the direction is that of the curve next to
    // it.
    glm::dvec3 slope = cubic.slope(t);
    if (glm::length(slope) < 1e-6 * glm::length(cubic.to - cubic.from)) {
        const double u = t < 0.5 ? t + 1e-4 : t - 1e-4;
        return {cubic.at(t), glm::normalize(cubic.slope(u)), glm::dvec3(0)};
    }
    const double speed = glm::length(slope);
    slope /= speed;
    const glm::dvec3 bend = cubic.bend(t);
    return {cubic.at(t), slope, (bend - slope * glm::dot(slope, bend)) / (speed * speed)};
}

double distanceToChord(const glm::dvec3& p, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 way = to - from;
    const double square = glm::dot(way, way);
    const double t = square > 0 ? std::clamp(glm::dot(p - from, way) / square, 0.0, 1.0) : 0;
    return glm::length(p - from - t * way);
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Whether the part of a cubic from t0 to t1 may be where the path matters: it lies within the hull of its
// Bezier points.
bool mayHold(const PathRegion& region, const Cubic& cubic, double t0, double t1) {
    const glm::dvec3 from = cubic.at(t0);
    const glm::dvec3 to = cubic.at(t1);
    const glm::dvec3 middle = 0.5 * (from + to);
    double radius = 0;
    for (const glm::dvec3& p :
         {from, from + (t1 - t0) / 3 * cubic.slope(t0), to - (t1 - t0) / 3 * cubic.slope(t1), to}) {
        radius = std::max(radius, glm::length(p - middle));
    }
    return region.mayHold(middle, radius);
}

// Adds the samples after t0 up to t1, halving until chords are close enough.
void appendSamples(std::vector<CurveSample>& samples, const Cubic& cubic, const PathRegion& region, double t0,
                   double t1, int level) {
    constexpr int kMaxLevel = 14;
    const CurveSample a = sampleAt(cubic, t0);
    const CurveSample b = sampleAt(cubic, t1);
    const double middle = 0.5 * (t0 + t1);
    const CurveSample m = sampleAt(cubic, middle);
    const auto off = [&](double t) { return distanceToChord(cubic.at(t), a.point, b.point); };
    const bool isFine =
        std::max({angleBetween(a.tangent, b.tangent), angleBetween(a.tangent, m.tangent)}) <= kChordTurn &&
        (std::max({off(middle), off(0.5 * (t0 + middle)), off(0.5 * (middle + t1))}) <= kChordTolerance ||
         !mayHold(region, cubic, t0, t1));
    if (isFine || level == kMaxLevel) {
        append(samples, b);
        return;
    }
    appendSamples(samples, cubic, region, t0, middle, level + 1);
    appendSamples(samples, cubic, region, middle, t1, level + 1);
}

// The way of points at equal distances of about one step.
std::vector<glm::dvec3> atEqualDistances(std::span<const glm::dvec3> points) {
    double length = 0;
    for (std::size_t n = 1; n < points.size(); ++n) {
        length += glm::length(points[n] - points[n - 1]);
    }
    constexpr double kMost = 1 << 18; // points: longer ways have longer steps
    const int count = int(std::clamp(std::round(length), 1.0, kMost));
    std::vector<glm::dvec3> out{points.front()};
    double passed = 0;
    for (std::size_t n = 1; n < points.size(); ++n) {
        const double edge = glm::length(points[n] - points[n - 1]);
        while (int(out.size()) < count && double(out.size()) * length / count <= passed + edge) {
            const double along = double(out.size()) * length / count - passed;
            out.push_back(glm::mix(points[n - 1], points[n], along / edge));
        }
        passed += edge;
    }
    out.push_back(points.back());
    return out;
}

// A Gaussian of `sigma` points; beyond the ends, which stay in place, the way goes on as its own mirror image
// through them.
std::vector<glm::dvec3> smoothed(std::span<const glm::dvec3> points, double sigma) {
    const int last = int(points.size()) - 1;
    const int reach = int(std::ceil(3 * sigma));
    const auto at = [&](int n) {
        const int inside = std::clamp(n < 0 ? -n : (n > last ? 2 * last - n : n), 0, last);
        const glm::dvec3& p = points[std::size_t(inside)];
        return n < 0 ? 2.0 * points.front() - p : (n > last ? 2.0 * points.back() - p : p);
    };
    std::vector<glm::dvec3> out(points.size());
    for (int n = 0; n <= last; ++n) {
        glm::dvec3 sum(0);
        double total = 0;
        for (int k = -reach; k <= reach; ++k) {
            const double weight = std::exp(-0.5 * k * k / (sigma * sigma));
            sum += weight * at(n + k);
            total += weight;
        }
        out[std::size_t(n)] = sum / total;
    }
    return out;
}

// Douglas and Peucker: the points that keep the way within `tolerance`, both ends among them.
std::vector<glm::dvec3> thinned(std::span<const glm::dvec3> points, double tolerance) {
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, points.size() - 1}};
    while (!parts.empty()) {
        const auto [first, last] = parts.back();
        parts.pop_back();
        std::size_t farthest = first;
        double most = tolerance;
        for (std::size_t n = first + 1; n < last; ++n) {
            const double distance = distanceToChord(points[n], points[first], points[last]);
            if (distance > most) {
                most = distance;
                farthest = n;
            }
        }
        if (farthest != first) {
            kept[farthest] = true;
            parts.emplace_back(first, farthest);
            parts.emplace_back(farthest, last);
        }
    }
    std::vector<glm::dvec3> out;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (kept[n]) {
            out.push_back(points[n]);
        }
    }
    return out;
}

} // namespace

bool PathRegion::mayHold(const glm::dvec3& point, double radius) const {
    const glm::dvec3 beyond = glm::max(glm::max(lo - point, point - hi), glm::dvec3(0));
    return glm::length(beyond) <= radius + reach;
}

std::vector<PathPiece> polylinePath(std::span<const glm::dvec3> all, FrameKind kind) {
    const auto points = withoutRepeats(all);
    std::vector<CurveSample> samples;
    for (std::size_t n = 1; n < points.size(); ++n) {
        const glm::dvec3 tangent = glm::normalize(points[n] - points[n - 1]);
        samples.push_back({points[n - 1], tangent, glm::dvec3(0)});
        samples.push_back({points[n], tangent, glm::dvec3(0)});
        if (n + 1 < points.size()) { // a corner's normal points to where the way turns
            const glm::dvec3 next = glm::normalize(points[n + 1] - points[n]);
            samples.push_back({points[n], tangent, next - tangent * glm::dot(next, tangent)});
        }
    }
    return framesAlong(samples, kind);
}

std::vector<PathPiece> splinePath(std::span<const glm::dvec3> all, FrameKind kind, const PathRegion& region) {
    const auto points = withoutRepeats(all);
    std::vector<CurveSample> samples;
    for (std::size_t n = 1; n < points.size(); ++n) {
        const glm::dvec3& from = points[n - 1];
        const glm::dvec3& to = points[n];
        const glm::dvec3 before = n > 1 ? points[n - 2] : 2.0 * from - to;
        const glm::dvec3 after = n + 1 < points.size() ? points[n + 1] : 2.0 * to - from;
        const Cubic cubic = catmullRom(before, from, to, after);
        const CurveSample first = sampleAt(cubic, 0);
        if (samples.empty() || angleBetween(samples.back().tangent, first.tangent) > 1e-6) {
            append(samples, first);
        }
        appendSamples(samples, cubic, region, 0, 1, 0);
    }
    return framesAlong(samples, kind);
}

std::vector<PathPiece> recordedPath(std::span<const glm::dvec3> all, FrameKind kind,
                                    const PathRegion& region) {
    constexpr double kSmoothing = 2; // steps
    constexpr double kTolerance = 0.1;
    const auto points = withoutRepeats(all);
    if (points.size() < 2) {
        return {};
    }
    const auto way = smoothed(atEqualDistances(points), kSmoothing);
    return splinePath(thinned(way, kTolerance), kind, region);
}

} // namespace vs::sculpt

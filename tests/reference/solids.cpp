// SPDX-License-Identifier: Apache-2.0
#include "reference/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vs::reference {

namespace {

constexpr int kSamples = 1 << 15;
constexpr int kStride = 32; // of the coarse search

glm::dvec3 acrossTo(const glm::dvec3& v, const glm::dvec3& tangent) {
    return glm::normalize(v - tangent * glm::dot(v, tangent));
}

} // namespace

glm::dvec3 helixAt(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& first, double radius,
                   double turns, double t) {
    const double angle = 2 * std::numbers::pi * turns * t;
    const glm::dvec3 second = glm::cross(glm::normalize(to - from), first);
    return glm::mix(from, to, t) + radius * (std::cos(angle) * first + std::sin(angle) * second);
}

glm::dvec3 centripetalAt(std::span<const glm::dvec3> points, double t) {
    const int last = int(points.size()) - 1;
    const int piece = std::clamp(int(t * last), 0, last - 1);
    const auto point = [&](int n) {
        return n < 0      ? 2.0 * points[0] - points[1]
               : n > last ? 2.0 * points[std::size_t(last)] - points[std::size_t(last) - 1]
                          : points[std::size_t(n)];
    };
    std::array<glm::dvec3, 4> p;
    std::array<double, 4> knot{};
    for (int n = 0; n < 4; ++n) {
        p[std::size_t(n)] = point(piece - 1 + n);
    }
    for (std::size_t n = 1; n < 4; ++n) {
        knot[n] = knot[n - 1] + std::sqrt(glm::length(p[n] - p[n - 1]));
    }
    const double u = knot[1] + (t * last - piece) * (knot[2] - knot[1]);
    const auto between = [&](const glm::dvec3& a, const glm::dvec3& b, std::size_t from, std::size_t to) {
        return ((knot[to] - u) * a + (u - knot[from]) * b) / (knot[to] - knot[from]);
    };
    const glm::dvec3 a1 = between(p[0], p[1], 0, 1);
    const glm::dvec3 a2 = between(p[1], p[2], 1, 2);
    const glm::dvec3 a3 = between(p[2], p[3], 2, 3);
    return between(between(a1, a2, 0, 2), between(a2, a3, 1, 3), 1, 2);
}

SweptCurve::SweptCurve(const std::function<glm::dvec3(double)>& at, Turning turning)
    : samples_(kSamples + 1) {
    const double h = 1.0 / kSamples;
    for (int n = 0; n <= kSamples; ++n) {
        samples_[std::size_t(n)].point = at(n * h);
    }
    for (std::size_t n = 0; n <= kSamples; ++n) {
        const std::size_t before = n > 0 ? n - 1 : 0;
        const std::size_t after = std::min<std::size_t>(n + 1, kSamples);
        samples_[n].tangent = glm::normalize(samples_[after].point - samples_[before].point);
        samples_[n].length =
            n > 0 ? samples_[n - 1].length + glm::length(samples_[n].point - samples_[n - 1].point) : 0;
    }
    // One-sided differences at the ends are off by half a sample: go on by one more.
    samples_.front().tangent = glm::normalize(2.0 * samples_[1].tangent - samples_[2].tangent);
    samples_.back().tangent =
        glm::normalize(2.0 * samples_[kSamples - 1].tangent - samples_[kSamples - 2].tangent);
    const glm::dvec3 start = samples_.front().tangent;
    glm::dvec3 x = acrossTo(std::abs(start.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), start);
    for (std::size_t n = 0; n <= kSamples; ++n) {
        Sample& sample = samples_[n];
        x = acrossTo(x, sample.tangent);
        if (turning == Turning::Normal) {
            const std::size_t middle = std::clamp<std::size_t>(n, 1, kSamples - 1);
            const glm::dvec3 bend = samples_[middle + 1].tangent - samples_[middle - 1].tangent;
            if (glm::length(bend) > 1e-9) {
                const glm::dvec3 normal = acrossTo(bend, sample.tangent);
                x = n > 0 && glm::dot(normal, x) < 0 ? -normal : normal;
            }
        }
        sample.x = x;
    }
}

SweptCurve::Located SweptCurve::locate(const glm::dvec3& p) const {
    const auto squared = [&](std::size_t n) {
        const glm::dvec3 d = p - samples_[n].point;
        return glm::dot(d, d);
    };
    std::size_t best = 0;
    for (std::size_t n = 0; n < samples_.size(); n += kStride) {
        best = squared(n) < squared(best) ? n : best;
    }
    const std::size_t lo = best > kStride ? best - kStride : 0;
    const std::size_t hi = std::min(best + kStride, samples_.size() - 1);
    for (std::size_t n = lo; n <= hi; ++n) {
        best = squared(n) < squared(best) ? n : best;
    }
    const Sample& sample = samples_[best];
    const glm::dvec3 d = p - sample.point;
    const glm::dvec3 y = glm::cross(sample.tangent, sample.x);
    const double along = sample.length + glm::dot(d, sample.tangent);
    return {{glm::dot(d, sample.x), glm::dot(d, y)}, along, samples_.back().length - along, sample.x, y};
}

OutlineDistance distanceTo(std::span<const glm::dvec2> polygon, const glm::dvec2& p) {
    OutlineDistance out;
    double least = 1e30;
    bool isInside = false;
    glm::dvec2 nearest(0);
    glm::dvec2 side(0);
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const glm::dvec2& a = polygon[n];
        const glm::dvec2& b = polygon[(n + 1) % polygon.size()];
        const glm::dvec2& c = polygon[(n + 2) % polygon.size()];
        const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        const double distance = glm::length(p - glm::mix(a, b, t));
        if (distance < least) {
            least = distance;
            nearest = glm::mix(a, b, t);
            side = b - a;
        }
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            isInside = !isInside;
        }
        if (glm::dot(glm::normalize(b - a), glm::normalize(c - b)) < std::cos(0.2)) {
            out.toCorner = std::min(out.toCorner, glm::length(p - b));
        }
    }
    out.distance = isInside ? -least : least;
    // Across the side; which way is out tells the point itself.
    out.normal = glm::normalize(glm::dvec2(side.y, -side.x));
    if (glm::dot(p - nearest, out.normal) * (isInside ? -1 : 1) < 0) {
        out.normal = -out.normal;
    }
    return out;
}

std::vector<glm::dvec2> ellipse(const glm::dvec2& radii) {
    std::vector<glm::dvec2> polygon;
    for (int n = 0; n < 2048; ++n) {
        const double angle = 2 * std::numbers::pi * n / 2048;
        polygon.push_back(radii * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

} // namespace vs::reference

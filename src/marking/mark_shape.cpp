// SPDX-License-Identifier: Apache-2.0
#include "marking/mark_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace vs::marking {

namespace {

// How far along a line of the given start and way the place nearest to p lies, 0 to 1.
template <typename V>
double nearestOn(const V& start, const V& way, const V& p) {
    const double length2 = glm::dot(way, way);
    return length2 > 0 ? std::clamp(glm::dot(p - start, way) / length2, 0.0, 1.0) : 0.0;
}

using Edge = std::pair<glm::dvec2, glm::dvec2>;

// The edges of outlines without those that are passed both ways.
std::vector<Edge> edgesOf(std::span<const AreaDistances::Outline> outlines) {
    std::map<std::array<double, 4>, int> times;
    for (const auto& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec2 a = outline[i];
            const glm::dvec2 b = outline[(i + 1) % outline.size()];
            const bool isForth = std::pair(a.x, a.y) < std::pair(b.x, b.y);
            const auto& [from, to] = isForth ? std::pair(a, b) : std::pair(b, a);
            times[{from.x, from.y, to.x, to.y}] += isForth ? 1 : -1;
        }
    }
    std::vector<Edge> edges;
    for (const auto& [ends, count] : times) {
        if (count % 2 != 0) {
            edges.push_back({{ends[0], ends[1]}, {ends[2], ends[3]}});
        }
    }
    return edges;
}

} // namespace

OnLine onLine(std::span<const PathPoint> path, const glm::dvec3& world) {
    OnLine found;
    const auto take = [&](const PathPoint& a, const PathPoint& b) {
        const double part = nearestOn(a.world, b.world - a.world, world);
        const double radius = glm::mix(a.radiusMm, b.radiusMm, part);
        const double inside = radius - glm::distance(glm::mix(a.world, b.world, part), world);
        if (inside > found.insideMm) {
            found = {inside, glm::mix(a.opacity, b.opacity, part)};
        }
    };
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        take(path[i], path[i + 1]);
    }
    if (path.size() == 1) {
        take(path[0], path[0]);
    }
    return found;
}

AreaDistances::AreaDistances(std::span<const Outline> outlines, double reach) : reach_(reach) {
    glm::dvec2 lo(std::numeric_limits<double>::max());
    glm::dvec2 hi = -lo;
    for (const auto& outline : outlines) {
        for (const glm::dvec2& p : outline) {
            lo = glm::min(lo, p);
            hi = glm::max(hi, p);
        }
    }
    if (lo.x > hi.x) {
        return;
    }
    lo_ = glm::ivec2(glm::floor(lo - reach)) - 1;
    size_ = glm::ivec2(glm::ceil(hi + reach)) + 2 - lo_;
    const auto edges = edgesOf(outlines);
    distances_.assign(std::size_t(size_.x) * std::size_t(size_.y), float(reach));
    std::vector<std::vector<float>> crossings(std::size_t(size_.y)); // of each row of centres
    for (const auto& [a, b] : edges) {
        const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(glm::min(a, b) - reach)) - lo_, 0);
        const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil(glm::max(a, b) + reach)) - lo_, size_ - 1);
        for (int y = first.y; y <= last.y; ++y) {
            const double row = lo_.y + y + 0.5;
            for (int x = first.x; x <= last.x; ++x) {
                const glm::dvec2 p(lo_.x + x + 0.5, row);
                const double distance = glm::distance(p, a + nearestOn(a, b - a, p) * (b - a));
                float& held = distances_[std::size_t(y) * std::size_t(size_.x) + std::size_t(x)];
                held = std::min(held, float(distance));
            }
            if ((a.y <= row) != (b.y <= row)) {
                crossings[std::size_t(y)].push_back(float(a.x + (row - a.y) / (b.y - a.y) * (b.x - a.x)));
            }
        }
    }
    for (int y = 0; y < size_.y; ++y) {
        auto& row = crossings[std::size_t(y)];
        std::sort(row.begin(), row.end());
        std::size_t passed = 0;
        for (int x = 0; x < size_.x; ++x) {
            while (passed < row.size() && double(row[passed]) <= lo_.x + x + 0.5) {
                ++passed;
            }
            float& held = distances_[std::size_t(y) * std::size_t(size_.x) + std::size_t(x)];
            held = passed % 2 == 1 ? held : -held;
        }
    }
}

double AreaDistances::at(glm::ivec2 pixel) const {
    const bool isInside =
        glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, size_));
    return isInside ? double(distances_[std::size_t(pixel.y) * std::size_t(size_.x) + std::size_t(pixel.x)])
                    : -reach_;
}

double AreaDistances::insidePixels(glm::dvec2 pixel) const {
    const glm::dvec2 q = pixel - 0.5 - glm::dvec2(lo_);
    const glm::ivec2 first(glm::floor(q));
    const glm::dvec2 part = q - glm::dvec2(first);
    return glm::mix(glm::mix(at(first), at(first + glm::ivec2(1, 0)), part.x),
                    glm::mix(at(first + glm::ivec2(0, 1)), at(first + 1), part.x), part.y);
}

} // namespace vs::marking

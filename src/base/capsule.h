// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vs {

// All points within `radius` of the straight way from `a` to `b`: what a round brush covers.
template <int N>
struct Capsule {
    using Point = glm::vec<N, double>;
    Point a;
    Point b;
    double radius;

    // The part of a straight line, point `from` + s * `along`, that lies in it: from the least s to the
    // greatest. Nothing if it misses it.
    [[nodiscard]] std::optional<Range> onLine(Point from, Point along) const {
        Range part{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
        const auto take = [&](std::optional<Range> one) {
            if (one) {
                part = {std::min(part.lo, one->lo), std::max(part.hi, one->hi)};
            }
        };
        // It is convex, so what lies between parts of the line in the balls and the cylinder does too.
        take(withinRadius(from - a, along));
        take(withinRadius(from - b, along));
        take(inCylinder(from, along));
        return part.lo <= part.hi ? std::optional(part) : std::nullopt;
    }

private:
    // Where |offset + s * along| <= radius.
    [[nodiscard]] std::optional<Range> withinRadius(Point offset, Point along) const {
        const double square = glm::dot(along, along);
        const double middle = -glm::dot(offset, along) / square;
        const Point nearest = offset + middle * along;
        const double left = radius * radius - glm::dot(nearest, nearest);
        if (!(left >= 0)) {
            return {};
        }
        const double half = std::sqrt(left / square);
        return Range{middle - half, middle + half};
    }
    // Where it is beside the way, and not beyond its ends.
    [[nodiscard]] std::optional<Range> inCylinder(Point from, Point along) const {
        const Point way = b - a;
        const double length = glm::length(way);
        if (!(length > 0)) {
            return {};
        }
        const Point axis = way / length;
        const auto beside = [&](Point v) { return v - glm::dot(v, axis) * axis; };
        const double start = glm::dot(from - a, axis);
        const double speed = glm::dot(along, axis);
        Range part{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        if (const Point across = beside(along); glm::dot(across, across) > 1e-20 * glm::dot(along, along)) {
            const auto near = withinRadius(beside(from - a), across);
            if (!near) {
                return {};
            }
            part = *near;
        } else if (glm::length(beside(from - a)) > radius) {
            return {};
        }
        if (std::abs(speed) > 1e-12 * glm::length(along)) {
            const double first = -start / speed;
            const double last = (length - start) / speed;
            part = {std::max(part.lo, std::min(first, last)), std::min(part.hi, std::max(first, last))};
        } else if (start < 0 || start > length) {
            return {};
        }
        return part.lo <= part.hi ? std::optional(part) : std::nullopt;
    }
};

// The part of the way from a to b, as shares of it from 0 to 1, on which a coordinate that goes evenly from
// `a` to `b` lies in a range. Nothing if it never does.
inline std::optional<Range> sharesWithin(double a, double b, const Range& range) {
    if (a == b) {
        return range.contains(a) ? std::optional(Range{0, 1}) : std::nullopt;
    }
    const double first = (range.lo - a) / (b - a);
    const double last = (range.hi - a) / (b - a);
    const Range part{std::max(0.0, std::min(first, last)), std::min(1.0, std::max(first, last))};
    return part.lo <= part.hi ? std::optional(part) : std::nullopt;
}

} // namespace vs

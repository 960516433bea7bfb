// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/outline.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vs::sculpt {

Outline freeFormOutline(std::span<const glm::dvec2> points) {
    Outline outline;
    for (const glm::dvec2& point : points) {
        if (outline.empty() || outline.back() != point) {
            outline.push_back(point);
        }
    }
    return outline;
}

Outline ellipseOutline(glm::dvec2 centre, glm::dvec2 radii) {
    // 256 corners stay within 7.5e-5 of the radius of the true curve.
    constexpr int kCorners = 256;
    Outline outline;
    for (int n = 0; n < kCorners; ++n) {
        const double angle = 2 * std::numbers::pi * n / kCorners;
        outline.push_back(centre + radii * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

Outline circleOutline(glm::dvec2 centre, double radius) { return ellipseOutline(centre, glm::dvec2(radius)); }

Outline rectangleOutline(glm::dvec2 a, glm::dvec2 b) { return {a, {b.x, a.y}, b, {a.x, b.y}}; }

Outline polylineOutline(std::span<const glm::dvec2> corners) { return freeFormOutline(corners); }

Outline starOutline(glm::dvec2 centre, double outer, double inner, int points) {
    Outline outline;
    for (int n = 0; n < 2 * points; ++n) {
        const double angle = std::numbers::pi * (0.5 + double(n) / points);
        outline.push_back(centre +
                          (n % 2 == 0 ? outer : inner) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

Outline subdivide(Outline outline, Subdivision scheme, int levels) {
    constexpr std::size_t kMost = std::size_t(1) << 22;
    for (int level = 0; level < levels && !outline.empty(); ++level) {
        const std::size_t count = outline.size();
        if (2 * count > kMost) {
            throw Error("an outline subdivided {} times has more than {} points; use fewer levels", levels,
                        kMost);
        }
        Outline finer;
        finer.reserve(2 * count);
        for (std::size_t n = 0; n < count; ++n) {
            const glm::dvec2& p = outline[n];
            const glm::dvec2& next = outline[(n + 1) % count];
            if (scheme == Subdivision::Chaikin) {
                finer.push_back(0.75 * p + 0.25 * next);
                finer.push_back(0.25 * p + 0.75 * next);
            } else {
                const glm::dvec2& last = outline[(n + count - 1) % count];
                finer.push_back(0.125 * last + 0.75 * p + 0.125 * next);
                finer.push_back(0.5 * (p + next));
            }
        }
        outline = std::move(finer);
    }
    return outline;
}

MaskWindow windowAround(const Outline& outline) {
    MaskWindow window;
    for (const glm::dvec2& point : outline) {
        window.include({point, point});
    }
    return window;
}

Outline clipToBox(Outline outline, glm::dvec2 lo, glm::dvec2 hi) {
    for (int side = 0; side < 4; ++side) {
        const int axis = side % 2;
        const double sign = side < 2 ? 1 : -1;
        const double limit = side < 2 ? hi[axis] : -lo[axis];
        const auto depth = [&](glm::dvec2 p) { return limit - sign * p[axis]; };
        if (std::all_of(outline.begin(), outline.end(), [&](glm::dvec2 p) { return depth(p) >= 0; })) {
            continue;
        }
        Outline inside;
        // Of a way along the side its ends are enough, however often it goes to and fro there.
        const auto addOnSide = [&](glm::dvec2 p) {
            p[axis] = sign * limit;
            const std::size_t count = inside.size();
            if (count >= 2 && inside[count - 1][axis] == p[axis] && inside[count - 2][axis] == p[axis]) {
                inside.back() = p;
            } else {
                inside.push_back(p);
            }
        };
        for (std::size_t n = 0; n < outline.size(); ++n) {
            const glm::dvec2 a = outline[n];
            const glm::dvec2 b = outline[(n + 1) % outline.size()];
            if (depth(a) >= 0) {
                inside.push_back(a);
            }
            if ((depth(a) >= 0) != (depth(b) >= 0)) {
                addOnSide(glm::mix(a, b, depth(a) / (depth(a) - depth(b))));
            }
        }
        outline = std::move(inside);
    }
    return outline;
}

} // namespace vs::sculpt

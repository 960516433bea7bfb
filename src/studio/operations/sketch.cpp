// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/sketch.h"

#include "sculpt/mask/mask.h"

#include <cmath>

namespace vs::studio {

namespace {

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 ab = b - a;
    const double l2 = glm::dot(ab, ab);
    const double s = l2 > 0 ? std::clamp(glm::dot(p - a, ab) / l2, 0.0, 1.0) : 0.0;
    return glm::length(p - (a + s * ab));
}

// A bitmap of the viewport that strokes are painted into.
struct Bitmap {
    glm::ivec2 size;
    std::vector<bool> set;

    explicit Bitmap(glm::ivec2 s) : size(s), set(std::size_t(s.x) * std::size_t(s.y)) {}

    template <typename Inside>
    void paint(glm::dvec2 lo, glm::dvec2 hi, Inside inside) {
        const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(lo)), glm::ivec2(0));
        const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil(hi)), size - 1);
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                if (inside(glm::dvec2(x + 0.5, y + 0.5))) {
                    set[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] = true;
                }
            }
        }
    }
};

void paintLine(Bitmap& bitmap, const std::vector<glm::dvec2>& points, double width) {
    // A line thinner than a pixel still marks the pixels that it runs through.
    const double half = std::max(width / 2, 0.71);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 a = points[i == 0 ? 0 : i - 1];
        const glm::dvec2 b = points[i];
        bitmap.paint(glm::min(a, b) - half, glm::max(a, b) + half,
                     [&](glm::dvec2 p) { return distanceToSegment(p, a, b) <= half; });
    }
}

bool isInside(const std::vector<glm::dvec2>& outline, glm::dvec2 p) {
    bool inside = false; // even-odd rule
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const glm::dvec2 a = outline[i];
        const glm::dvec2 b = outline[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
            inside = !inside;
        }
    }
    return inside;
}

void paintFilled(Bitmap& bitmap, const std::vector<glm::dvec2>& outline) {
    if (outline.empty()) {
        return;
    }
    glm::dvec2 lo = outline.front();
    glm::dvec2 hi = lo;
    for (const auto& p : outline) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    bitmap.paint(lo, hi, [&](glm::dvec2 p) { return isInside(outline, p); });
}

} // namespace

std::vector<glm::dvec2> outlineOf(const Sketch& sketch) {
    const auto& p = sketch.points;
    switch (sketch.shape) {
    case Shape::FreeForm:
        return p.size() >= 3 ? sculpt::freeFormOutline(p) : sculpt::Outline{};
    case Shape::Polyline:
    case Shape::Stencil:
        return p.size() >= 3 ? sculpt::polylineOutline(p) : sculpt::Outline{};
    case Shape::Ellipse:
        return sculpt::ellipseOutline(0.5 * (p.at(0) + p.at(1)), 0.5 * glm::abs(p.at(1) - p.at(0)));
    case Shape::Circle:
        return sculpt::circleOutline(p.at(0), glm::length(p.at(1) - p.at(0)));
    case Shape::Rectangle:
        break;
    }
    return sculpt::rectangleOutline(p.at(0), p.at(1));
}

glm::dvec2 centreOf(const std::vector<glm::dvec2>& outline) {
    if (outline.empty()) {
        return {};
    }
    glm::dvec2 lo = outline.front();
    glm::dvec2 hi = lo;
    for (const auto& p : outline) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    return 0.5 * (lo + hi);
}

std::vector<glm::vec2> pixelsUnder(const std::vector<Sketch>& strokes, double widthPixels,
                                   glm::ivec2 viewport) {
    Bitmap bitmap(viewport);
    for (const Sketch& stroke : strokes) {
        if (stroke.shape == Shape::FreeForm || stroke.shape == Shape::Polyline) {
            paintLine(bitmap, stroke.points, widthPixels);
        } else {
            paintFilled(bitmap, outlineOf(stroke));
        }
    }
    std::vector<glm::vec2> pixels;
    for (std::size_t i = 0; i < bitmap.set.size(); ++i) {
        if (bitmap.set[i]) {
            const auto width = std::size_t(viewport.x);
            const glm::ivec2 pixel(int(i % width), int(i / width));
            pixels.push_back(glm::vec2(pixel) + 0.5F);
        }
    }
    return pixels;
}

} // namespace vs::studio

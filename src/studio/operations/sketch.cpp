// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/sketch.h"

#include "base/capsule.h"
#include "sculpt/mask/mask.h"
#include "studio/operations/filled_rows.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {

namespace {

// A bitmap of the viewport that strokes are painted into: pixels are in it by their centres.
class Bitmap {
public:
    explicit Bitmap(glm::ivec2 size)
        : size_(size), set_(std::size_t(size.x) * std::size_t(size.y)), rows_(std::size_t(size.y), size.x) {}

    // Both ends in pixels, y down.
    void paintLine(glm::dvec2 a, glm::dvec2 b, double half) {
        const Capsule<2> brush{a, b, half};
        for (int y = firstRow(std::min(a.y, b.y) - half); y < endRow(std::max(a.y, b.y) + half); ++y) {
            if (const auto part = brush.onLine({0, y + 0.5}, {1, 0})) {
                // Both ends are in the line.
                fill(y, std::ceil(part->lo - 0.5), std::floor(part->hi - 0.5) + 1);
            }
        }
    }

    // By the even-odd rule.
    void paintFilled(const std::vector<glm::dvec2>& outline) {
        const auto [low, high] =
            std::minmax_element(outline.begin(), outline.end(), [](auto a, auto b) { return a.y < b.y; });
        if (low == outline.end()) {
            return;
        }
        for (int y = firstRow(low->y); y < endRow(high->y); ++y) {
            if (rows_.isFull(std::size_t(y))) {
                continue;
            }
            findCrossings(outline, y + 0.5);
            for (std::size_t n = 0; n + 1 < crossings_.size(); n += 2) {
                fill(y, std::ceil(crossings_[n] - 0.5), std::ceil(crossings_[n + 1] - 0.5));
            }
        }
    }

    // The centres of all that were painted, row by row.
    [[nodiscard]] std::vector<glm::vec2> pixels() const {
        std::vector<glm::vec2> pixels;
        pixels.reserve(std::size_t(std::count(set_.begin(), set_.end(), true)));
        const auto width = std::size_t(size_.x);
        for (std::size_t i = 0; i < set_.size(); ++i) {
            if (set_[i]) {
                pixels.push_back(glm::vec2(glm::ivec2(int(i % width), int(i / width))) + 0.5F);
            }
        }
        return pixels;
    }

private:
    [[nodiscard]] int firstRow(double y) const {
        return int(std::clamp(std::floor(y), 0.0, double(size_.y)));
    }
    [[nodiscard]] int endRow(double y) const {
        return int(std::clamp(std::ceil(y) + 1, 0.0, double(size_.y)));
    }

    // Where a row crosses the outline, in order: an even number of places.
    void findCrossings(const std::vector<glm::dvec2>& outline, double y) {
        crossings_.clear();
        for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            const glm::dvec2 a = outline[i];
            const glm::dvec2 b = outline[j];
            if ((a.y > y) != (b.y > y)) {
                crossings_.push_back((b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x);
            }
        }
        std::sort(crossings_.begin(), crossings_.end());
    }

    // Pixels [begin, end) of a row.
    void fill(int y, double begin, double end) {
        const double width = size_.x;
        const auto row = set_.begin() + std::ptrdiff_t(y) * size_.x;
        rows_.fill(std::size_t(y), int(std::clamp(begin, 0.0, width)), int(std::clamp(end, 0.0, width)),
                   [&](int first, int last) { std::fill(row + first, row + last, true); });
    }

    glm::ivec2 size_;
    std::vector<bool> set_;
    FilledRows rows_;
    std::vector<double> crossings_;
};

void paintLine(Bitmap& bitmap, const std::vector<glm::dvec2>& points, double width) {
    // A line thinner than a pixel still marks the pixels that it runs through.
    const double half = std::max(width / 2, 0.71);
    for (std::size_t i = 0; i < points.size(); ++i) {
        bitmap.paintLine(points[i == 0 ? 0 : i - 1], points[i], half);
    }
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
            bitmap.paintFilled(outlineOf(stroke));
        }
    }
    return bitmap.pixels();
}

} // namespace vs::studio

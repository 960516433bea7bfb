// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/measurement_marks.h"

#include "image/drawing.h"
#include "render/marks/annotation.h"
#include "studio/editing/vessel_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace vs::studio {

namespace {

constexpr image::Colour kLine{0.18, 0.86, 0.48};
constexpr image::Colour kShade{0.04, 0.05, 0.06, 0.75}; // around lines, to be seen on anything
constexpr image::Colour kNarrow{0.98, 0.45, 0.32};
constexpr image::Colour kText{0.97, 0.97, 0.95};
constexpr double kFilled = 0.18; // opacity of what an outline encloses

bool isBeforeViewer(const Measured& measured, const render::ViewRays& rays) {
    return rays.isOrthographic ||
           std::all_of(measured.world.begin(), measured.world.end(),
                       [&](const glm::dvec3& place) { return glm::dot(place - rays.eye, rays.forward) > 0; });
}

class Marker {
public:
    explicit Marker(glm::ivec2 size) : drawing_(size), size_(size), scale_(render::annotationScale(size)) {}

    void line(const image::Outline& points) {
        drawing_.line(points, 4 * scale_, kShade);
        drawing_.line(points, 2 * scale_, kLine);
    }
    void outline(const image::Outline& points) {
        drawing_.fill(points, kLine.faded(kFilled));
        drawing_.border({points}, 4 * scale_, kShade);
        drawing_.border({points}, 2 * scale_, kLine);
    }
    void dot(glm::dvec2 at) {
        const double r = 3 * scale_;
        const image::Outline diamond{at + glm::dvec2(r, 0), at + glm::dvec2(0, r), at - glm::dvec2(r, 0),
                                     at - glm::dvec2(0, r)};
        drawing_.border({diamond}, 2 * scale_, kShade);
        drawing_.fill(diamond, kLine);
    }
    // Below and to the right of a place, where there is room and no other label.
    void label(glm::dvec2 at, const std::string& said) {
        image::Text text{said, at + glm::dvec2(9, 20) * scale_, 15 * scale_};
        const double width = image::textWidth(said, text.size);
        text.place.x =
            std::clamp(text.place.x, 4 * scale_, std::max(size_.x - width - 4 * scale_, 4 * scale_));
        text.place.y = std::clamp(text.place.y, 18 * scale_, size_.y - 6 * scale_);
        const double line = 19 * scale_;
        const auto overlaps = [&](const Label& other) {
            return std::abs(other.left.y - text.place.y) < line &&
                   text.place.x < other.left.x + other.width && other.left.x < text.place.x + width;
        };
        while (std::any_of(labels_.begin(), labels_.end(), overlaps) && text.place.y + line < size_.y) {
            text.place.y += line;
        }
        labels_.push_back({text.place, width});
        drawing_.textBorder(text, 3.2 * scale_, kShade);
        drawing_.text(text, kText);
    }
    // Across a vessel where it is narrow.
    void narrowing(glm::dvec2 at) {
        const double r = 5 * scale_;
        const image::Outline diamond{at + glm::dvec2(r, 0), at + glm::dvec2(0, r), at - glm::dvec2(r, 0),
                                     at - glm::dvec2(0, r)};
        drawing_.border({diamond}, 3.5 * scale_, kShade);
        drawing_.border({diamond}, 1.8 * scale_, kNarrow);
    }
    [[nodiscard]] double scale() const { return scale_; }
    [[nodiscard]] image::Image picture() const { return drawing_.picture(); }

private:
    struct Label {
        glm::dvec2 left;
        double width;
    };
    image::Drawing drawing_;
    glm::ivec2 size_;
    double scale_;
    std::vector<Label> labels_; // that stand there
};

// Where the value stands: at an angle's corner, at the lowest point of an outline, else half-way.
glm::dvec2 labelPlace(const Measured& measured, const image::Outline& seen) {
    if (measured.measure.kind == Measure::Kind::Angle) {
        return seen[1];
    }
    if (measured.isArea()) {
        return *std::max_element(seen.begin(), seen.end(),
                                 [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
    }
    return seen.size() == 2 ? 0.5 * (seen[0] + seen[1]) : seen[seen.size() / 2];
}

// The curves of vessels, one below the other at the upper right, as many as there is room for.
void blendCharts(image::Image& picture, std::span<const Measured> measurements,
                 const volume::GridGeometry& geometry, double scale) {
    const glm::ivec2 size(glm::dvec2(260, 120) * scale);
    const int margin = int(12 * scale);
    int top = margin;
    for (const Measured& measured : measurements) {
        if (measured.isVessel() && top + size.y < picture.height && size.x + margin < picture.width) {
            image::blend(picture, vesselChart(measured, geometry, size, scale),
                         {picture.width - margin - size.x, top});
            top += size.y + margin;
        }
    }
}

} // namespace

void markMeasurements(image::Image& picture, std::span<const Measured> measurements,
                      const render::ViewRays& rays, const volume::GridGeometry& geometry) {
    if (measurements.empty()) {
        return;
    }
    Marker marker({picture.width, picture.height});
    for (const Measured& measured : measurements) {
        if (measured.world.empty() || !isBeforeViewer(measured, rays)) {
            continue;
        }
        image::Outline seen;
        std::transform(measured.world.begin(), measured.world.end(), std::back_inserter(seen),
                       [&](const glm::dvec3& place) { return rays.project(place); });
        if (measured.isArea()) {
            marker.outline(seen);
        } else {
            marker.line(seen);
            marker.dot(seen.front());
            marker.dot(seen.back());
        }
        const std::string values = valuesOf(measured);
        const std::string label = labelOf(measured, geometry);
        marker.label(labelPlace(measured, seen),
                     values.empty() ? label : fmt::format("{}, {}", label, values));
        if (measured.isNarrowed()) {
            marker.narrowing(seen[measured.narrowest->index]);
            marker.label(seen[measured.narrowest->index], narrowestOf(measured, geometry));
        }
    }
    image::blend(picture, marker.picture());
    blendCharts(picture, measurements, geometry, marker.scale());
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/stroke_marks.h"

#include "base/error.h"
#include "image/drawing.h"
#include "render/camera/viewport_fit.h"

#include <algorithm>

namespace vs::studio {

namespace {

constexpr image::Colour kAtRest{0.18, 0.86, 0.48};
constexpr image::Colour kCutting{0.98, 0.27, 0.22};
constexpr image::Colour kShade{0.04, 0.05, 0.06, 0.75}; // around lines, to be seen on anything
constexpr double kFilled = 0.3;                         // opacity of what a line encloses
constexpr double kLine = 2.2;                           // pixels, of a picture 870 high
constexpr double kHeight = 870;

class Marker {
public:
    Marker(glm::ivec2 size, image::Colour tint)
        : drawing_(size), tint_(tint), width_(kLine * std::max(size.y / kHeight, 0.4)) {}

    void area(const Drawn::Line& outline) {
        drawing_.fill(outline, tint_.faded(kFilled));
        edge(outline);
    }
    void edge(const Drawn::Line& outline) {
        drawing_.border({outline}, 2 * width_, kShade);
        drawing_.border({outline}, width_, tint_);
    }
    void line(const Drawn::Line& points, double width) {
        if (points.size() < 2) {
            return;
        }
        drawing_.line(points, width + width_, kShade);
        drawing_.line(points, width, tint_);
    }
    void way(const Drawn::Line& points) { line(points, width_); }
    [[nodiscard]] image::Image picture() const { return drawing_.picture(); }

private:
    image::Drawing drawing_;
    image::Colour tint_;
    double width_;
};

} // namespace

void markStrokes(image::Image& picture, const Drawn& drawn, bool isCutting, const View& view,
                 const volume::GridGeometry& geometry) {
    const Canvas canvas = drawn.canvas.value_or(Canvas{.view = view});
    if (!(canvas.view.camera == view.camera)) {
        throw Error("the strokes to be shown were drawn from another camera than the picture's; show them in "
                    "the view in which they were drawn");
    }
    const glm::ivec2 size(picture.width, picture.height);
    const render::ViewportFit pixel(view.camera, geometry, canvas.viewport, size);
    const auto fit = [&pixel](Drawn::Line line) {
        std::transform(line.begin(), line.end(), line.begin(), pixel);
        return line;
    };
    Marker marker(size, isCutting ? kCutting : kAtRest);
    for (const Drawn::Line& area : drawn.areas) {
        if (isCutting) { // all that it went over; before, the tool and its way are clear enough
            for (const glm::dvec2& place : drawn.way) {
                marker.edge(fit(drawn.areaAt(area, place)));
            }
        }
        // The tool is where it begins before it cuts, and then where it ended.
        const auto& way = drawn.way;
        marker.area(fit(way.empty() ? area : drawn.areaAt(area, isCutting ? way.back() : way.front())));
    }
    for (const Drawn::Line& line : drawn.lines) {
        marker.line(fit(line), drawn.lineWidth * pixel.scale());
    }
    marker.way(fit(drawn.way));
    image::blend(picture, marker.picture());
}

} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "transfer/function_picture.h"

#include "render/colours/colour_map.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

QColor mixed(const QColor& below, glm::dvec3 linear, double opacity) {
    const auto over = render::colourFromLinear(linear);
    const auto mix = [opacity](int a, int b) { return int(std::lround(a + (b - a) * opacity)); };
    return {mix(below.red(), over.x), mix(below.green(), over.y), mix(below.blue(), over.z)};
}

Range widened(Range range, double part) {
    const double by = range.width() > 0 ? part * range.width() : 1;
    return {range.lo - by, range.hi + by};
}

Range unite(const Range& a, const Range& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

// Everything that a function's shapes cover: intensities, gradients.
std::pair<Range, Range> extent(const std::vector<render::Shape>& shapes) {
    Range values{1e300, -1e300};
    Range gradients{1e300, -1e300};
    for (const render::Shape& shape : shapes) {
        if (const auto* trapezoid = std::get_if<render::Trapezoid>(&shape.form)) {
            values = unite(values, unite(trapezoid->base, trapezoid->top));
            gradients = unite(gradients, trapezoid->gradients);
        } else {
            const auto& painting = std::get<render::Painting>(shape.form);
            values = unite(values, painting.values);
            gradients = unite(gradients, painting.gradients);
        }
    }
    if (shapes.empty()) {
        return {{0, 1}, {0, 1}};
    }
    return {widened(values, 0.05), {std::max(gradients.lo, 0.0), gradients.hi}};
}

void drawShapes(QImage& image, const render::TransferFunction& function, const QColor& ground) {
    const render::FunctionSampler sampler(function);
    const auto [values, gradients] = extent(function.shapes);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double value = values.lo + (x + 0.5) / image.width() * values.width();
            const double gradient = gradients.hi - (y + 0.5) / image.height() * gradients.width();
            const glm::dvec4 seen = sampler.at(value, gradient);
            image.setPixelColor(x, y, mixed(ground, glm::dvec3(seen), std::sqrt(seen.w)));
        }
    }
}

void drawCurve(QImage& image, const render::TransferFunction& function, const QColor& ground) {
    const render::FunctionSampler sampler(function);
    const Range range = widened({function.points.front().position, function.points.back().position}, 0.05);
    const int strip = std::max(2, image.height() / 4);
    const int high = image.height() - strip - 1;
    for (int x = 0; x < image.width(); ++x) {
        const double at = range.lo + (x + 0.5) / image.width() * range.width();
        const glm::dvec4 seen = sampler.at(at, at);
        const int top = high - int(std::lround(std::sqrt(seen.w) * high)); // faint ones show too
        for (int y = 0; y < image.height(); ++y) {
            const bool isFilled = y > high || (y >= top && y < high);
            image.setPixelColor(x, y, mixed(ground, glm::dvec3(seen), isFilled ? 1 : 0));
        }
    }
}

} // namespace

QImage functionPicture(const render::TransferFunction& function, QSize pixels, const QColor& ground) {
    QImage image(pixels, QImage::Format_RGB32);
    image.fill(ground);
    render::TransferFunction plain = function;
    plain.positions = render::Positions::Absolute; // a picture of the function by itself
    if (function.kind == render::FunctionKind::TwoD) {
        drawShapes(image, plain, ground);
    } else {
        drawCurve(image, plain, ground);
    }
    return image;
}

QImage colourMapPicture(const std::string& map, QSize pixels) {
    QImage image(pixels, QImage::Format_RGB32);
    const render::ColourMap* found = render::findColourMap(map);
    for (int x = 0; x < pixels.width() && found != nullptr; ++x) {
        const auto linear =
            glm::clamp(render::linearFromOklab(found->at((x + 0.5) / pixels.width())), 0.0, 1.0);
        const auto colour = render::colourFromLinear(linear);
        for (int y = 0; y < pixels.height(); ++y) {
            image.setPixelColor(x, y, QColor(colour.x, colour.y, colour.z));
        }
    }
    return image;
}

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#include "render/marks/draw_annotations.h"

#include "base/check.h"
#include "image/drawing.h"
#include "render/colours/colour.h"

#include <algorithm>
#include <cmath>

namespace vs::render {

namespace {

using image::Drawing;

constexpr image::Colour kLight{0.97, 0.97, 0.95};
constexpr image::Colour kDark{0.06, 0.07, 0.08};
constexpr image::Colour kPointedAt{0.25, 0.60, 0.95, 0.6};

image::Colour inkColour(Ink ink) { return ink == Ink::Light ? kLight : kDark; }
image::Colour borderColour(Ink ink) { return ink == Ink::Light ? kDark.faded(0.75) : kLight.faded(0.8); }

// The studio light of render/shaders/shading.glsl on an ivory cube, a little brighter in the shade so that
// letters stay legible there. The normal is in the viewer's axes.
image::Colour shade(glm::dvec3 normal) {
    const glm::dvec3 key = glm::normalize(glm::dvec3(-0.45, 0.65, 0.75));
    const glm::dvec3 fill = glm::normalize(glm::dvec3(0.8, 0.05, 0.5));
    const glm::dvec3 albedo{0.80, 0.785, 0.75};
    const glm::dvec3 sky = glm::mix(glm::dvec3(0.13), glm::dvec3(0.20, 0.21, 0.22), 0.5 + 0.5 * normal.y);
    const glm::dvec3 light = 0.80 * std::max(glm::dot(normal, key), 0.0) * glm::dvec3(1.0, 0.97, 0.92) +
                             0.24 * std::max(glm::dot(normal, fill), 0.0) * glm::dvec3(0.85, 0.92, 1.0) + sky;
    const glm::dvec3 c = displayFromLinear(glm::min(albedo * light, 1.0));
    return {c.x, c.y, c.z};
}

image::Text textOf(const DirectionLetter& letter) {
    image::Text text;
    text.text = std::string(1, letter.letter);
    text.size = letter.size;
    text.align = image::Align::Centre;
    text.isBold = true;
    text.axes = letter.axes;
    text.place = letter.place + letter.axes[1] * (0.5 * image::kCapHeight * letter.size);
    return text;
}

// Cut into the face: the light falls from above, so the lower edge of the cut shines.
void drawOnFace(Drawing& drawing, const DirectionLetter& letter, double scale) {
    image::Text text = textOf(letter);
    const glm::dvec2 place = text.place;
    text.place = place + glm::dvec2(0.5, 1.0) * scale;
    drawing.text(text, image::Colour{1, 1, 1, 0.5 * letter.opacity});
    text.place = place;
    drawing.text(text, image::Colour{0.10, 0.11, 0.13, letter.opacity});
}

void drawBeside(Drawing& drawing, const DirectionLetter& letter, Ink ink, double scale) {
    const image::Text text = textOf(letter);
    drawing.textBorder(text, 3.2 * scale, borderColour(ink).faded(letter.opacity));
    drawing.text(text, inkColour(ink).faded(letter.opacity));
}

// Lightness of a pixel on white paper, 0..255.
double lightness(const std::uint8_t* pixel) {
    const double alpha = pixel[3] / 255.0;
    return alpha * (0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]) + (1 - alpha) * 255;
}

void blendWithInk(image::Image& picture, const auto& draw) {
    const Annotation place = draw(Ink::Light);
    const Ink ink = inkFor(picture, place.corner, {place.image.width, place.image.height});
    const Annotation drawn = ink == Ink::Light ? place : draw(ink);
    image::blend(picture, drawn.image, drawn.corner);
}

} // namespace

Annotation drawScaleBar(const ScaleBar& bar, glm::ivec2 size, Ink ink, double density) {
    const double scale = annotationScale(size, density);
    const double textSize = 16 * scale;
    const double thick = std::max(1.0, std::round(2.4 * scale));
    const double tick = std::round(9 * scale);
    const double edge = 1.6 * scale; // of the border
    const double width = image::textWidth(bar.label, textSize);
    // Above the bar's middle, but inside the picture where the text is the longer one.
    image::Text label{bar.label, 0.5 * (bar.left + bar.right), textSize, image::Align::Centre};
    label.place.x = std::max(label.place.x, bar.left.x + 0.5 * width);
    label.place.y -= thick + 6 * scale;

    // Seen from its lower left corner: along the bottom, up and around both ticks.
    const glm::dvec2 a = bar.left;
    const glm::dvec2 b = bar.right;
    const image::Outline outline{a,
                                 b,
                                 {b.x, b.y - tick},
                                 {b.x - thick, b.y - tick},
                                 {b.x - thick, b.y - thick},
                                 {a.x + thick, a.y - thick},
                                 {a.x + thick, a.y - tick},
                                 {a.x, a.y - tick}};
    const double around = std::ceil(2 * edge) + 2;
    const glm::ivec2 lo(glm::floor(glm::dvec2(a.x - around, label.place.y - textSize - around)));
    const glm::ivec2 hi(
        glm::ceil(glm::dvec2(std::max(b.x, label.place.x + 0.5 * width) + around, b.y + around)));
    Drawing drawing(hi - lo, lo);
    drawing.border({outline}, 2 * edge, borderColour(ink));
    drawing.textBorder(label, 2 * edge, borderColour(ink));
    drawing.fill(outline, inkColour(ink));
    drawing.text(label, inkColour(ink));
    return {drawing.picture(), lo};
}

Annotation drawOrientationMarker(const OrientationMarker& marker, glm::ivec2 size, Ink ink, double density) {
    const double scale = annotationScale(size, density);
    const glm::ivec2 lo(glm::floor(marker.centre - marker.radius));
    const glm::ivec2 hi(glm::ceil(marker.centre + marker.radius));
    Drawing drawing(hi - lo, lo);
    std::vector<image::Outline> outlines;
    for (const auto& facet : marker.facets) {
        outlines.push_back(facet.corners);
    }
    drawing.border(outlines, 2.6 * scale, kDark.faded(ink == Ink::Light ? 0.75 : 0.6));
    for (const auto& facet : marker.facets) {
        const image::Colour colour = shade(facet.normal);
        // A hair of border closes the seam between smooth edges of neighbours.
        drawing.border({facet.corners}, 0.5, colour);
        drawing.fill(facet.corners, colour);
    }
    for (const auto& piece : marker.lit) {
        drawing.fill(piece, kPointedAt);
    }
    for (const auto& letter : marker.letters) {
        if (letter.isOnFace) {
            drawOnFace(drawing, letter, scale);
        } else {
            drawBeside(drawing, letter, ink, scale);
        }
    }
    return {drawing.picture(), lo};
}

Ink inkFor(const image::Image& picture, glm::ivec2 corner, glm::ivec2 size) {
    const glm::ivec2 lo = glm::max(corner, glm::ivec2(0));
    const glm::ivec2 hi = glm::min(corner + size, glm::ivec2(picture.width, picture.height));
    double sum = 0;
    double count = 0;
    for (int y = lo.y; y < hi.y; ++y) {
        for (int x = lo.x; x < hi.x; ++x) {
            sum += lightness(picture.pixel(x, y));
            ++count;
        }
    }
    return sum > 127 * count ? Ink::Dark : Ink::Light;
}

void annotate(image::Image& picture, const ViewRays& rays, const volume::GridGeometry& geometry) {
    VS_CHECK(rays.size == glm::ivec2(picture.width, picture.height));
    const ScaleBar bar = scaleBar(rays, geometry);
    const OrientationMarker marker = orientationMarker(rays);
    blendWithInk(picture, [&](Ink ink) { return drawScaleBar(bar, rays.size, ink); });
    blendWithInk(picture, [&](Ink ink) { return drawOrientationMarker(marker, rays.size, ink); });
}

} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
#include "image/drawing.h"

#include "base/error.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vs::image {

struct Release {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};

using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Context = std::unique_ptr<cairo_t, Release>;

namespace {

Surface makeSurface(glm::ivec2 size) {
    Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.x, size.y));
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
        throw Error("a drawing of {} x {} pixels cannot be made ({})", size.x, size.y,
                    cairo_status_to_string(cairo_surface_status(surface.get())));
    }
    return surface;
}

void setColour(cairo_t* context, Colour c) {
    cairo_set_source_rgba(context, c.red, c.green, c.blue, c.alpha);
}

void setFont(cairo_t* context, double size, bool isBold) {
    // Hinting would move glyphs to whole pixels, so that small and large pictures would differ in their
    // layout.
    const std::unique_ptr<cairo_font_options_t, Release> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context, options.get());
    cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           isBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, size);
}

// Length of the UTF-8 character at a place: 0 if there is none.
std::size_t characterAt(const std::string& text, std::size_t place) {
    const auto lead = std::uint8_t(text[place]);
    const std::size_t length = lead < 0x80U   ? 1
                               : lead < 0xC2U ? 0
                               : lead < 0xE0U ? 2
                               : lead < 0xF0U ? 3
                               : lead < 0xF5U ? 4
                                              : 0;
    if (length == 0 || place + length > text.size()) {
        return 0;
    }
    // Neither longer than need be, nor half of a pair of UTF-16, nor beyond Unicode.
    const auto second = length > 1 ? std::uint8_t(text[place + 1]) : std::uint8_t(0x80);
    if ((lead == 0xE0U && second < 0xA0U) || (lead == 0xEDU && second > 0x9FU) ||
        (lead == 0xF0U && second < 0x90U) || (lead == 0xF4U && second > 0x8FU)) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((std::uint8_t(text[place + i]) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    return length;
}

// Names of files may be any bytes; Cairo draws nothing more after one that is not UTF-8.
std::string legible(const std::string& text) {
    std::string result;
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t length = characterAt(text, place);
        result += length > 0 ? text.substr(place, length) : "\uFFFD";
        place += std::max<std::size_t>(length, 1);
    }
    return result;
}

cairo_text_extents_t extentsOf(cairo_t* context, const std::string& text) {
    cairo_text_extents_t extents{};
    cairo_text_extents(context, legible(text).c_str(), &extents);
    return extents;
}

void addOutline(cairo_t* context, const Outline& outline) {
    cairo_new_sub_path(context);
    for (const auto& point : outline) {
        cairo_line_to(context, point.x, point.y);
    }
}

// Left of where the text begins, so that its part named by `align` lies at the origin. What is centred is
// what is seen: single letters would stand askew by their advance.
double startOf(cairo_t* context, const Text& text) {
    const auto extents = extentsOf(context, text.text);
    switch (text.align) {
    case Align::Centre:
        return -(extents.x_bearing + 0.5 * extents.width);
    case Align::Right:
        return -extents.x_advance;
    case Align::Left:
        break;
    }
    return 0;
}

void addText(cairo_t* context, const Text& text) {
    cairo_save(context);
    cairo_matrix_t carry;
    cairo_matrix_init(&carry, text.axes[0].x, text.axes[0].y, text.axes[1].x, text.axes[1].y, text.place.x,
                      text.place.y);
    cairo_transform(context, &carry);
    setFont(context, text.size, text.isBold);
    cairo_new_path(context);
    cairo_move_to(context, startOf(context, text), 0);
    cairo_text_path(context, legible(text.text).c_str());
    cairo_restore(context); // the path stays where it is
}

// Cairo's pixels are native 32-bit words, premultiplied.
void storePixel(std::uint8_t* to, std::uint32_t from) {
    const std::uint32_t alpha = from >> 24;
    const auto straight = [&](std::uint32_t value) {
        return alpha == 0 ? std::uint8_t(0)
                          : std::uint8_t(std::min(255U, ((value & 255U) * 255U + alpha / 2) / alpha));
    };
    to[0] = straight(from >> 16);
    to[1] = straight(from >> 8);
    to[2] = straight(from);
    to[3] = std::uint8_t(alpha);
}

void blendPixel(std::uint8_t* onto, const std::uint8_t* above) {
    const int a = above[3];
    if (a == 0) {
        return;
    }
    // Alphas in 1/255^2 until the end; with straight alpha what lies below counts by its own.
    const int below = onto[3] * (255 - a);
    const int total = a * 255 + below;
    for (int c = 0; c < 3; ++c) {
        onto[c] = std::uint8_t((above[c] * a * 255 + onto[c] * below + total / 2) / total);
    }
    onto[3] = std::uint8_t((total + 127) / 255);
}

} // namespace

struct Drawing::Impl {
    glm::ivec2 size;
    Surface surface;
    Context context;
};

double textWidth(const std::string& text, double size, bool isBold) {
    const Surface surface = makeSurface({1, 1});
    const Context context(cairo_create(surface.get()));
    setFont(context.get(), size, isBold);
    return extentsOf(context.get(), text).x_advance;
}

Drawing::Drawing(glm::ivec2 size, glm::ivec2 corner) : impl_(std::make_unique<Impl>()) {
    impl_->size = size;
    impl_->surface = makeSurface(size);
    impl_->context.reset(cairo_create(impl_->surface.get()));
    cairo_translate(impl_->context.get(), -corner.x, -corner.y);
    cairo_set_line_join(impl_->context.get(), CAIRO_LINE_JOIN_ROUND);
    // The finest grid of its rasteriser.
    cairo_set_antialias(impl_->context.get(), CAIRO_ANTIALIAS_BEST);
}

Drawing::~Drawing() = default;
Drawing::Drawing(Drawing&&) noexcept = default;
Drawing& Drawing::operator=(Drawing&&) noexcept = default;

void Drawing::fill(const Outline& outline, Colour colour) {
    cairo_t* context = impl_->context.get();
    cairo_new_path(context);
    addOutline(context, outline);
    setColour(context, colour);
    cairo_set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(context);
    cairo_set_fill_rule(context, CAIRO_FILL_RULE_WINDING); // glyphs overlap themselves
}

void Drawing::fillBox(glm::dvec2 lo, glm::dvec2 hi, Colour colour) {
    fill({lo, {hi.x, lo.y}, hi, {lo.x, hi.y}}, colour);
}

void Drawing::line(const Outline& points, double width, Colour colour) {
    cairo_t* context = impl_->context.get();
    cairo_new_path(context);
    addOutline(context, points);
    setColour(context, colour);
    cairo_set_line_width(context, width);
    cairo_stroke(context);
}

void Drawing::border(const std::vector<Outline>& outlines, double width, Colour colour) {
    cairo_t* context = impl_->context.get();
    cairo_new_path(context);
    for (const auto& outline : outlines) {
        addOutline(context, outline);
        cairo_close_path(context);
    }
    setColour(context, colour);
    cairo_set_line_width(context, width);
    cairo_stroke(context);
}

void Drawing::text(const Text& text, Colour colour) {
    addText(impl_->context.get(), text);
    setColour(impl_->context.get(), colour);
    cairo_fill(impl_->context.get());
}

void Drawing::textBorder(const Text& text, double width, Colour colour) {
    addText(impl_->context.get(), text);
    setColour(impl_->context.get(), colour);
    cairo_set_line_width(impl_->context.get(), width);
    cairo_stroke(impl_->context.get());
}

void Drawing::showOnly(glm::dvec2 lo, glm::dvec2 hi) {
    cairo_new_path(impl_->context.get());
    cairo_rectangle(impl_->context.get(), lo.x, lo.y, hi.x - lo.x, hi.y - lo.y);
    cairo_clip(impl_->context.get());
}

void Drawing::showAll() { cairo_reset_clip(impl_->context.get()); }

Image Drawing::picture() const {
    if (cairo_status(impl_->context.get()) != CAIRO_STATUS_SUCCESS) {
        throw Error("a drawing failed ({}); is the package fonts-dejavu-core installed?",
                    cairo_status_to_string(cairo_status(impl_->context.get())));
    }
    cairo_surface_t* surface = impl_->surface.get();
    cairo_surface_flush(surface);
    const unsigned char* rows = cairo_image_surface_get_data(surface);
    const auto stride = std::size_t(cairo_image_surface_get_stride(surface));
    Image image(impl_->size.x, impl_->size.y);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::uint32_t word = 0;
            std::memcpy(&word, rows + std::size_t(y) * stride + 4 * std::size_t(x), sizeof word);
            storePixel(image.pixel(x, y), word);
        }
    }
    return image;
}

void blend(Image& onto, const Image& above, glm::ivec2 corner) {
    const glm::ivec2 lo = glm::max(corner, glm::ivec2(0));
    const glm::ivec2 hi =
        glm::min(corner + glm::ivec2(above.width, above.height), glm::ivec2(onto.width, onto.height));
    for (int y = lo.y; y < hi.y; ++y) {
        for (int x = lo.x; x < hi.x; ++x) {
            blendPixel(onto.pixel(x, y), above.pixel(x - corner.x, y - corner.y));
        }
    }
}

} // namespace vs::image

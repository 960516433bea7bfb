// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

#include "base/math.h"

#include <memory>
#include <string>
#include <vector>

namespace vs::image {

// A display (sRGB) colour with straight alpha, all 0..1.
struct Colour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;

    [[nodiscard]] Colour faded(double opacity) const { return {red, green, blue, alpha * opacity}; }
};

// Corners in pixels, y down; pixel centres at + 0.5.
using Outline = std::vector<glm::dvec2>;

enum class Align { Left, Centre, Right };

// One line of text, UTF-8 (other bytes show as a replacement sign). It is set as if `place` were the origin
// and then carried over by `axes`: their columns say where its reading direction and its downward direction
// go.
struct Text {
    std::string text;
    glm::dvec2 place{0}; // on the baseline; which part of the text lies there says `align`
    double size = 14;    // of the em, in pixels
    Align align = Align::Left;
    bool isBold = false;
    glm::dmat2 axes{1.0};
};

// Height of a capital letter as part of the em.
inline constexpr double kCapHeight = 0.729;

// Width in pixels of what a text's glyphs advance by.
double textWidth(const std::string& text, double size, bool isBold = false);

// Smooth shapes and text on a transparent picture of their own, which then is a picture itself or is blended
// over one. Coordinates are those of a larger picture of which this one shows the part at `corner`. Glyphs
// are drawn as outlines, unhinted, so that they look the same at every size. Throws Error if there is no
// room.
class Drawing {
public:
    explicit Drawing(glm::ivec2 size, glm::ivec2 corner = {0, 0});
    ~Drawing();
    Drawing(Drawing&&) noexcept;
    Drawing& operator=(Drawing&&) noexcept;

    // Fills what an outline encloses, by the even-odd rule.
    void fill(const Outline& outline, Colour colour);
    // Fills the box between two corners.
    void fillBox(glm::dvec2 lo, glm::dvec2 hi, Colour colour);
    // Draws an open line with butt ends.
    void line(const Outline& points, double width, Colour colour);
    // Draws closed lines with round corners. Where several overlap the colour counts once.
    void border(const std::vector<Outline>& outlines, double width, Colour colour);
    void text(const Text& text, Colour colour);
    // Draws a line around the text's glyphs, half of it outside: drawn before the text, it sets it off.
    void textBorder(const Text& text, double width, Colour colour);
    // What is drawn later shows only between two corners, until the next call of showAll().
    void showOnly(glm::dvec2 lo, glm::dvec2 hi);
    void showAll();

    // What has been drawn so far.
    [[nodiscard]] Image picture() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Lays a picture over another with its first pixel at `corner`. What lies outside is left out, and pixels
// under fully transparent ones stay exactly what they were.
void blend(Image& onto, const Image& above, glm::ivec2 corner = {0, 0});

} // namespace vs::image

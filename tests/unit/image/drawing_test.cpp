// SPDX-License-Identifier: Apache-2.0
#include "image/drawing.h"

#include <gtest/gtest.h>

#include <array>

namespace vs::image {
namespace {

std::array<int, 4> pixel(const Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return {p[0], p[1], p[2], p[3]};
}

// Smallest box around all pixels that are not fully transparent: x, y, beyond x, beyond y.
std::array<int, 4> boundsOf(const Image& image) {
    std::array<int, 4> box{image.width, image.height, 0, 0};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.pixel(x, y)[3] > 0) {
                box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x + 1),
                       std::max(box[3], y + 1)};
            }
        }
    }
    return box;
}

TEST(Drawing, ABoxOnPixelBordersFillsThosePixelsAndNoOthers) {
    Drawing drawing({10, 8});
    drawing.fillBox({2, 3}, {5, 4}, {1, 0.5, 0, 1});
    const Image image = drawing.picture();
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 10; ++x) {
            const bool inside = x >= 2 && x < 5 && y == 3;
            EXPECT_EQ(pixel(image, x, y), (inside ? std::array{255, 128, 0, 255} : std::array{0, 0, 0, 0}));
        }
    }
}

TEST(Drawing, ColoursStayStraightUnderPartialAlpha) {
    Drawing drawing({4, 4});
    drawing.fillBox({0, 0}, {4, 4}, {1, 0.5, 0.25, 0.5});
    const auto [red, green, blue, alpha] = pixel(drawing.picture(), 1, 1);
    EXPECT_NEAR(alpha, 128, 1);
    EXPECT_EQ(red, 255);
    EXPECT_NEAR(green, 128, 2); // premultiplied 8 bits lose one level or two
    EXPECT_NEAR(blue, 64, 2);
}

TEST(Drawing, CoordinatesAreThoseOfTheLargerPicture) {
    Drawing drawing({6, 6}, {100, 200});
    drawing.fillBox({101, 202}, {103, 204}, {0, 0, 0, 1});
    EXPECT_EQ(boundsOf(drawing.picture()), (std::array{1, 2, 3, 4}));
}

TEST(Drawing, TextStandsOnItsBaselineWhereItIsAligned) {
    const auto bounds = [](Align align, glm::dmat2 axes) {
        Drawing drawing({200, 200});
        drawing.text({"HEH", {100, 100}, 40, align, false, axes}, {0, 0, 0, 1});
        return boundsOf(drawing.picture());
    };
    const auto centred = bounds(Align::Centre, glm::dmat2(1.0));
    EXPECT_EQ(centred[3], 100) << "capitals end on the baseline";
    EXPECT_NEAR(centred[1], 100 - 40 * kCapHeight, 1.01);
    EXPECT_NEAR(100 - centred[0], centred[2] - 100, 1.01);
    EXPECT_GE(bounds(Align::Left, glm::dmat2(1.0))[0], 100);
    EXPECT_LE(bounds(Align::Right, glm::dmat2(1.0))[2], 100);
    // Reading upward: what was to the right is above.
    const auto upward = bounds(Align::Left, glm::dmat2(glm::dvec2(0, -1), glm::dvec2(1, 0)));
    EXPECT_LE(upward[3], 100);
    EXPECT_EQ(upward[2], 100);
}

TEST(Drawing, TextGrowsWithItsSize) {
    EXPECT_NEAR(textWidth("5 cm", 200), 10 * textWidth("5 cm", 20), 1e-2);
    EXPECT_GT(textWidth("5 cm", 20, true), textWidth("5 cm", 20));
}

TEST(Drawing, BytesThatAreNoTextDoNotStopTheDrawing) {
    for (const std::string bytes :
         {"\xFF", "a\x80", "\xC3", "\xE2\x82", "\xED\xA0\x80", "\xC0\xAF", "\xF8\x88\x80\x80"}) {
        Drawing drawing({60, 40});
        EXPECT_GT(textWidth(bytes, 20), 0);
        drawing.text({bytes, {2, 30}, 20}, {0, 0, 0, 1});
        drawing.fillBox({50, 0}, {60, 10}, {0, 0, 0, 1});
        EXPECT_EQ(drawing.picture().pixel(55, 5)[3], 255);
    }
    EXPECT_EQ(textWidth("\xC3\xA9", 20), textWidth("é", 20));
}

TEST(Drawing, WhereBordersOverlapTheColourCountsOnce) {
    Drawing drawing({20, 20});
    const Outline box{{5, 5}, {15, 5}, {15, 15}, {5, 15}};
    drawing.border({box, box}, 4, {0, 0, 0, 0.5});
    EXPECT_NEAR(drawing.picture().pixel(10, 5)[3], 128, 1);
}

TEST(Drawing, NothingShowsOutsideWhatMayShow) {
    Drawing drawing({20, 20});
    drawing.showOnly({5, 5}, {9, 9});
    drawing.fillBox({0, 0}, {20, 20}, {0, 0, 0, 1});
    EXPECT_EQ(boundsOf(drawing.picture()), (std::array{5, 5, 9, 9}));
    drawing.showAll();
    drawing.fillBox({0, 0}, {20, 20}, {0, 0, 0, 1});
    EXPECT_EQ(boundsOf(drawing.picture()), (std::array{0, 0, 20, 20}));
}

TEST(Blend, ChangesNothingUnderTransparentPixels) {
    Image onto(3, 3);
    for (std::size_t i = 0; i < onto.rgba.size(); ++i) {
        onto.rgba[i] = std::uint8_t(37 * i); // among them colours under an alpha of zero
    }
    const Image before = onto;
    blend(onto, Image(3, 3));
    EXPECT_EQ(onto.rgba, before.rgba);
}

TEST(Blend, IsOverWithStraightAlpha) {
    const auto over = [](std::array<std::uint8_t, 4> below, std::array<std::uint8_t, 4> above) {
        Image a(1, 1);
        Image b(1, 1);
        std::copy(below.begin(), below.end(), a.rgba.begin());
        std::copy(above.begin(), above.end(), b.rgba.begin());
        blend(a, b);
        return pixel(a, 0, 0);
    };
    EXPECT_EQ(over({10, 20, 30, 255}, {200, 100, 0, 255}), (std::array{200, 100, 0, 255}));
    EXPECT_EQ(over({0, 0, 0, 255}, {255, 255, 255, 51}), (std::array{51, 51, 51, 255}));
    // On nothing the colour stays whole: it must not darken towards transparent black.
    EXPECT_EQ(over({0, 0, 0, 0}, {200, 100, 50, 77}), (std::array{200, 100, 50, 77}));
    const auto half = over({100, 0, 0, 128}, {0, 100, 0, 128});
    EXPECT_NEAR(half[3], 192, 1);
    EXPECT_NEAR(half[0], 33, 1);
    EXPECT_NEAR(half[1], 67, 1);
}

TEST(Blend, LeavesOutWhatLiesOutside) {
    Image onto(2, 2);
    Image above(4, 4);
    std::fill(above.rgba.begin(), above.rgba.end(), std::uint8_t(255));
    blend(onto, above, {1, -3});
    EXPECT_EQ(boundsOf(onto), (std::array{1, 0, 2, 1}));
    blend(onto, above, {10, 10});
}

} // namespace
} // namespace vs::image

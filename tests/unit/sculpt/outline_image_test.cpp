// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/outline_image.h"

#include "base/error.h"
#include "sculpt/mask/mask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vs::sculpt {
namespace {

image::Image pictureOf(int width, int height, const std::function<double(double x, double y)>& inside) {
    image::Image picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto value =
                std::uint8_t(std::lround(255 * std::clamp(inside(x + 0.5, y + 0.5), 0.0, 1.0)));
            std::fill_n(picture.pixel(x, y), 3, value);
            picture.pixel(x, y)[3] = 255;
        }
    }
    return picture;
}

double areaOf(const Outline& outline) { // by the even-odd rule, of loops that do not cross
    double area = 0;
    const MaskRaster raster = rasterize(outline, 0.1);
    for (const float value : raster.values) {
        area += value * 0.1 * 0.1;
    }
    return area;
}

TEST(OutlineImage, ADiscIsADisc) {
    const auto picture =
        pictureOf(100, 80, [](double x, double y) { return 30.5 - std::hypot(x - 50, y - 40); });
    const Outline outline = outlineFromImage(picture, 50);
    ASSERT_GT(outline.size(), 50U);
    for (const glm::dvec2 point : outline) {
        EXPECT_NEAR(glm::length(point), 15, 0.15);
    }
}

TEST(OutlineImage, RingsAndSeveralPiecesKeepTheirAreas) {
    const auto picture = pictureOf(120, 80, [](double x, double y) {
        const double ring = 8.5 - std::abs(std::hypot(x - 40, y - 40) - 20);
        const double dot = 10.5 - std::hypot(x - 95, y - 40);
        return std::max(ring, dot);
    });
    const double expected = 3.14159265 * (28 * 28 - 12 * 12 + 10 * 10) / 4;
    EXPECT_NEAR(areaOf(outlineFromImage(picture, 60)), expected, 0.02 * expected);
}

TEST(OutlineImage, CornersThatTouchAreKeptApart) {
    const auto picture = pictureOf(4, 4, [](double x, double y) { return (x < 2) == (y < 2) ? 1.0 : 0.0; });
    EXPECT_NEAR(areaOf(outlineFromImage(picture, 4)), 8, 1);
}

TEST(OutlineImage, ThePicturesTopIsUp) {
    const auto picture = pictureOf(20, 20, [](double, double y) { return y < 5 ? 1.0 : 0.0; });
    for (const glm::dvec2 point : outlineFromImage(picture, 20)) {
        EXPECT_GT(point.y, 4);
    }
}

TEST(OutlineImage, AnEmptyPictureIsRefused) {
    EXPECT_THROW(outlineFromImage(pictureOf(8, 8, [](double, double) { return 0.0; }), 8), Error);
}

} // namespace
} // namespace vs::sculpt

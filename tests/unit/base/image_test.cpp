// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "image/compare.h"
#include "image/image.h"

#include <gtest/gtest.h>

namespace vs::image {
namespace {

Image pattern(int width, int height) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] = i % 4 == 3 ? 255 : std::uint8_t(i * 37 % 251);
    }
    return image;
}

TEST(Image, PngGivesBackEveryPixel) {
    const auto path =
        std::filesystem::temp_directory_path() / ("vs_png_" + std::to_string(getpid()) + ".png");
    const Image image = pattern(31, 17);
    writePng(path, image);
    const Image back = readPng(path);
    std::filesystem::remove(path);
    EXPECT_EQ(back.width, 31);
    EXPECT_EQ(back.height, 17);
    EXPECT_EQ(back.rgba, image.rgba);
}

TEST(Image, CompareTellsMaximumMeanAndShareOfPixels) {
    const Image a = pattern(10, 10);
    Image b = a;
    EXPECT_EQ(compare(a, b).max, 0);
    b.pixel(3, 4)[1] = std::uint8_t(a.pixel(3, 4)[1] ^ 64);
    const auto d = compare(a, b);
    EXPECT_EQ(d.max, 64);
    EXPECT_NEAR(d.mean, 64.0 / 300, 1e-9);
    EXPECT_NEAR(d.changedFraction, 0.01, 1e-9);
    EXPECT_THROW(compare(a, Image(9, 10)), Error);
}

TEST(Image, AFileThatIsNoPngIsNamed) {
    try {
        readPng("/dev/null");
        FAIL();
    } catch (const ReadError& error) {
        EXPECT_EQ(std::string(error.what()).rfind("/dev/null: not a readable PNG", 0), 0U) << error.what();
    }
}

} // namespace
} // namespace vs::image

// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "gpu/render/still.h"
#include "image/compare.h"
#include "phantom/phantom.h"

namespace vs::render {
namespace {

using BackgroundPictureTest = test::GlTest;
using test::Still;

constexpr glm::ivec2 kSize{150, 120};

// A bright ball in noise-free air, seen with antialiased edges.
struct Ball : Still {
    explicit Ball(const char* background, int samples = 5)
        : Still(phantom::makeBall({48, 48, 48}, {23.5, 23.5, 23.5}, 12), {60, 200}, {30, 20}, kSize) {
        frame.background = backgroundFromName(background);
        frame.samples = samples;
    }
};

constexpr Mode kModesHere[] = {Mode::Surface, Mode::Mip, Mode::XRay};

std::array<int, 4> pixelOf(const image::Image& picture, int x, int y) {
    const auto* p = picture.pixel(x, y);
    return {p[0], p[1], p[2], p[3]};
}

int farthest(const std::array<int, 4>& a, const std::array<int, 4>& b) {
    int most = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        most = std::max(most, std::abs(a[i] - b[i]));
    }
    return most;
}

TEST_F(BackgroundPictureTest, CornersHaveTheColourAskedFor) {
    struct Case {
        const char* name;
        std::array<int, 4> top;
        std::array<int, 4> bottom;
    };
    for (const auto& [name, top, bottom] :
         {Case{"white", {255, 255, 255, 255}, {255, 255, 255, 255}},
          Case{"black", {0, 0, 0, 255}, {0, 0, 0, 255}}, Case{"transparent", {0, 0, 0, 0}, {0, 0, 0, 0}},
          Case{"#FF8040", {255, 128, 64, 255}, {255, 128, 64, 255}},
          Case{"#804020:#10E0A0", {128, 64, 32, 255}, {16, 224, 160, 255}}}) {
        Ball ball(name);
        for (const Mode mode : kModesHere) {
            const auto picture = ball.picture(mode);
            const int dither = top == bottom ? 0 : 1; // what changes is dithered
            EXPECT_LE(farthest(pixelOf(picture, 0, 0), top), dither) << name;
            EXPECT_LE(farthest(pixelOf(picture, kSize.x - 1, kSize.y - 1), bottom), dither) << name;
        }
    }
}

TEST_F(BackgroundPictureTest, ATransparentPictureOverTheStudiosBackgroundIsTheStudiosPicture) {
    Ball transparent("transparent");
    Ball studio("studio");
    // What the studio looks like with nothing in it.
    Still nothing(phantom::makeBall({48, 48, 48}, {23.5, 23.5, 23.5}, 12), {300, 400}, {30, 20}, kSize);
    for (const Mode mode : kModesHere) {
        const auto over = transparent.picture(mode);
        const auto expected = studio.picture(mode);
        const auto behind = nothing.picture(mode);
        int worst = 0;
        int partly = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i) {
            const auto a = pixelOf(over, i % kSize.x, i / kSize.x);
            const auto b = pixelOf(behind, i % kSize.x, i / kSize.x);
            const auto e = pixelOf(expected, i % kSize.x, i / kSize.x);
            partly += a[3] > 0 && a[3] < 255 ? 1 : 0;
            for (std::size_t c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs((a[c] * a[3] + b[c] * (255 - a[3])) / 255 - e[c]));
            }
        }
        EXPECT_LE(worst, 2) << name(mode);
        EXPECT_GT(partly, 100) << name(mode);
        EXPECT_EQ(pixelOf(over, 2, 2)[3], 0) << name(mode);
    }
    EXPECT_EQ(pixelOf(transparent.picture(Mode::Surface), kSize.x / 2, kSize.y / 2)[3], 255);
}

TEST_F(BackgroundPictureTest, ASurfaceLooksTheSameOnEveryBackground) {
    const auto onWhite = pixelOf(Ball("white").picture(Mode::Surface), kSize.x / 2, kSize.y / 2);
    for (const char* name : {"studio", "black", "transparent", "#FF0000"}) {
        EXPECT_EQ(pixelOf(Ball(name).picture(Mode::Surface), kSize.x / 2, kSize.y / 2), onWhite) << name;
    }
}

TEST_F(BackgroundPictureTest, RaysOfLightStayBrightOnWhite) {
    for (const Mode mode : {Mode::Mip, Mode::XRay}) {
        const auto picture = Ball("white").picture(mode);
        const auto centre = pixelOf(picture, kSize.x / 2, kSize.y / 2);
        const auto beside = pixelOf(picture, kSize.x / 2 + 32, kSize.y / 2); // in the box, beside the ball
        EXPECT_LE(beside[0], 44) << name(mode) << ": dark as a film";
        EXPECT_GT(centre[0], beside[0] + 50) << name(mode);
    }
}

TEST_F(BackgroundPictureTest, UnfinishedSamplesDoNotChangeThePicture) {
    // Some squares of pixels have one sample more than the others while a picture is under way.
    Still still(phantom::makeBall({48, 48, 48}, {23.5, 23.5, 23.5}, 12), {60, 200}, {30, 20}, {900, 700});
    still.frame.background = backgroundFromName("white");
    still.frame.samples = 3;
    still.caster.start(still.frame);
    while (still.caster.completedSamples() < 1) {
        still.caster.renderSome(0);
    }
    still.caster.renderSome(0);
    ASSERT_EQ(still.caster.completedSamples(), 1) << "the picture is too small to be half done";
    const auto early = still.caster.readPicture();
    still.caster.render(still.frame);
    EXPECT_LT(image::compare(early, still.caster.readPicture()).mean, 2);
    EXPECT_EQ(pixelOf(early, 0, 0), (std::array<int, 4>{255, 255, 255, 255}));
}

} // namespace
} // namespace vs::render

// SPDX-License-Identifier: Apache-2.0
// Inverted pictures: MIP and X-ray dark on light.
#include "gpu/gl_test.h"
#include "gpu/render/segment_stage.h"
#include "gpu/render/still.h"
#include "image/compare.h"
#include "phantom/phantom.h"

#include <array>
#include <tuple>

namespace vs::render {
namespace {

using InvertedPictureTest = test::GlTest;
using test::Still;

constexpr glm::ivec2 kPictureSize{150, 120};
constexpr int kDither = 1; // of 255, once in each of two pictures; rounding is the other
constexpr Mode kInvertible[] = {Mode::Mip, Mode::XRay};

struct BallToInvert : Still {
    explicit BallToInvert(const char* background)
        : Still(phantom::makeBall({48, 48, 48}, {23.5, 23.5, 23.5}, 12), {60, 200}, {30, 20}, kPictureSize) {
        frame.background = backgroundFromName(background);
        frame.samples = 3;
    }

    image::Image seen(Mode mode, bool isInverted) {
        frame.isInverted = isInverted;
        return picture(mode);
    }
};

TEST_F(InvertedPictureTest, OnWhiteItIsTheNegativeOfThePictureOnBlack) {
    BallToInvert onBlack("black");
    BallToInvert onWhite("white");
    for (const Mode mode : kInvertible) {
        const auto positive = onBlack.seen(mode, false);
        const auto negative = onWhite.seen(mode, true);
        int dark = 0;
        for (std::size_t i = 0; i < positive.rgba.size(); ++i) {
            const bool isAlpha = i % 4 == 3;
            ASSERT_NEAR(negative.rgba[i], isAlpha ? 255 : 255 - positive.rgba[i], 2 * kDither) << i;
            dark += !isAlpha && negative.rgba[i] < 100 ? 1 : 0;
        }
        EXPECT_GT(dark, 1000) << "the ball is dark";
    }
}

TEST_F(InvertedPictureTest, TheStudiosBackgroundIsLightAndChosenOnesStay) {
    for (const auto& [name, least, most] : {std::tuple{"studio", 200, 254}, std::tuple{"white", 255, 255},
                                            std::tuple{"black", 0, 0}, std::tuple{"#808080", 128, 128}}) {
        BallToInvert ball(name);
        for (const Mode mode : kInvertible) {
            const auto picture = ball.seen(mode, true);
            for (const int channel : {0, 1, 2}) {
                EXPECT_GE(picture.pixel(0, 0)[channel], least) << name;
                EXPECT_LE(picture.pixel(0, 0)[channel], most) << name;
            }
        }
    }
}

TEST_F(InvertedPictureTest, ItHidesAsMuchOfATransparentBackground) {
    BallToInvert ball("transparent");
    for (const Mode mode : kInvertible) {
        const auto positive = ball.seen(mode, false);
        const auto negative = ball.seen(mode, true);
        int covered = 0;
        for (std::size_t i = 0; i < positive.rgba.size(); i += 4) {
            ASSERT_EQ(negative.rgba[i + 3], positive.rgba[i + 3]) << i;
            if (positive.rgba[i + 3] > 0) {
                ASSERT_NEAR(negative.rgba[i], 255 - positive.rgba[i], 2 * kDither) << i;
                ++covered;
            }
        }
        EXPECT_GT(covered, 1000);
    }
}

TEST_F(InvertedPictureTest, SurfacesAreNotInverted) {
    BallToInvert ball("studio");
    EXPECT_EQ(ball.seen(Mode::Surface, true).rgba, ball.seen(Mode::Surface, false).rgba);
}

TEST_F(InvertedPictureTest, ColoursOfFunctionsAndSegmentsStay) {
    const auto middle = [](const image::Image& picture) {
        const auto* p = picture.pixel(test::kSize.x / 2, test::kSize.y / 2);
        return std::array<int, 3>{p[0], p[1], p[2]};
    };
    for (const Mode mode : kInvertible) {
        // What can be seen is wholly in a segment that is red, or of a function that is red everywhere, at
        // full brightness.
        const auto ball = [](glm::dvec3 p) { return glm::length(p - test::kCentre) < 12 ? 255 : 0; };
        test::SegmentStage tinted(ball);
        tinted.nest(test::kRed, test::kRed);
        tinted.frame.xrayGain = 100;
        test::SegmentStage coloured(ball);
        TransferFunction red;
        red.positions = Positions::Absolute;
        red.points = {{0, 1, {220, 60, 50}}, {255, 1, {220, 60, 50}}};
        coloured.classify(red);
        coloured.frame.xrayGain = 100;
        for (test::SegmentStage* stage : {&tinted, &coloured}) {
            stage->frame.isInverted = false;
            const auto positive = middle(stage->picture(mode));
            stage->frame.isInverted = true;
            const auto negative = middle(stage->picture(mode));
            for (std::size_t channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(negative[channel], positive[channel], 2 * kDither);
            }
            EXPECT_GT(positive[0], positive[2] + 50) << "it is red";
        }
    }
}

} // namespace
} // namespace vs::render

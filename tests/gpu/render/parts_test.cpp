// SPDX-License-Identifier: Apache-2.0
// Pictures of several parts (dual rendering): where they are seen, how large, and which hides which.
#include "gpu/gl_test.h"
#include "gpu/render/stage.h"
#include "image/compare.h"
#include "phantom/phantom.h"

#include <cmath>

namespace vs::render {
namespace {

using PartsTest = test::GlTest;
using test::Stage;

constexpr Projection kProjections[] = {Projection::Perspective, Projection::Orthographic};

// Pixels brighter than the black background: how many, and their middle.
struct Outline {
    int pixels = 0;
    glm::dvec2 centre{0};
    glm::ivec2 extent{0};
};

bool isSeen(const image::Image& picture, int x, int y) {
    const auto* p = picture.pixel(x, y);
    return p[0] + p[1] + p[2] > 6;
}

Outline outlineOf(const image::Image& picture) {
    Outline outline;
    glm::ivec2 lower(picture.width, picture.height);
    glm::ivec2 upper(-1);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            if (isSeen(picture, x, y)) {
                ++outline.pixels;
                outline.centre += glm::dvec2(x, y) + 0.5;
                lower = glm::min(lower, glm::ivec2(x, y));
                upper = glm::max(upper, glm::ivec2(x, y));
            }
        }
    }
    outline.centre /= std::max(outline.pixels, 1);
    outline.extent = upper - lower + 1;
    return outline;
}

// A ball in the middle of the grid, of which `cut` (a plane through its middle, or all) was taken out.
struct CutBall : Stage {
    explicit CutBall(bool takesAll = true)
        : Stage(phantom::makeBall({48, 48, 48}, glm::dvec3(23.5), 13), {100, 200}) {
        darken();
        if (takesAll) {
            sculpt([](glm::dvec3) { return 1.0; });
        } else {
            cutAbove(23.7);
        }
    }

    // The cut-out part alone, where `placement` puts it.
    image::Image partAlone(const Placement& placement, Mode mode) {
        const Frame before = frame;
        frame.pasted.clear();
        frame.rays = seenFromPart(before.rays, placement, volume.geometry);
        frame.scene.view = field::SculptureView::Probe;
        auto result = picture(mode);
        frame = before;
        rebuild();
        return result;
    }
};

TEST_F(PartsTest, APartPastedWhereItWasMakesThePictureWhole) {
    for (const Projection projection : kProjections) {
        CutBall ball(false);
        ball.look({60, 20, 1, {}, projection}, {160, 128});
        ball.paste({Placement{}});
        for (const Mode mode : {Mode::Surface, Mode::Mip}) {
            const auto pasted = ball.picture(mode);
            ball.frame.pasted.clear();
            ball.frame.scene.sculpture = nullptr;
            const auto whole = ball.picture(mode);
            ball.frame.scene.sculpture = &ball.sculpture;
            ball.paste({Placement{}});
            const auto difference = image::compare(pasted, whole);
            if (mode == Mode::Mip) {
                EXPECT_EQ(difference.max, 0) << "each sample belongs to one of the two";
            } else {
                // Along the cut's edge, a line of about 90 of 20480 pixels, a ray may meet the cut's face.
                EXPECT_LT(difference.changedFraction, 0.005);
                EXPECT_LT(difference.mean, 0.1);
            }
        }
    }
}

TEST_F(PartsTest, AMovedPartAppearsMovedAsFar) {
    for (const Projection projection : kProjections) {
        CutBall ball;
        ball.look({40, 25, 0.6, {}, projection}, {200, 160});
        const glm::dvec3 centre = ball.volume.geometry.centreWorld();
        ball.paste({Placement{}});
        const auto before = outlineOf(ball.picture(Mode::Surface));
        EXPECT_GT(before.pixels, 1000);
        for (const glm::dvec3 move :
             {glm::dvec3(12, 0, 0), glm::dvec3(-7.3, 0, 9.1), glm::dvec3(5, -20, 3)}) {
            ball.paste({Placement{move, {}, 1}});
            const auto after = outlineOf(ball.picture(Mode::Surface));
            const glm::dvec2 moved = after.centre - before.centre;
            const glm::dvec2 expected =
                ball.frame.rays.project(centre + move) - ball.frame.rays.project(centre);
            EXPECT_LT(glm::length(moved - expected), 0.15) << "pixels";
        }
    }
}

TEST_F(PartsTest, APartTwiceAsLargeHasTwiceTheOutline) {
    CutBall ball;
    ball.look({40, 25, 0.6, {}, Projection::Orthographic}, {200, 160});
    ball.paste({Placement{}});
    const auto once = outlineOf(ball.picture(Mode::Surface));
    ball.paste({Placement{{}, {}, 2}});
    const auto twice = outlineOf(ball.picture(Mode::Surface));
    EXPECT_LE(glm::length(glm::dvec2(twice.extent - 2 * once.extent)), 3) << "a pixel at each end";
    EXPECT_NEAR(double(twice.pixels) / once.pixels, 4, 0.05);
    EXPECT_LT(glm::length(twice.centre - once.centre), 0.15);
}

TEST_F(PartsTest, TheMipOfPartsIsTheGreaterOfEach) {
    for (const Projection projection : kProjections) {
        CutBall ball(false);
        ball.look({30, 20, 0.8, {}, projection}, {160, 128});
        const Placement placement{{14, 4, 8}, {0, 30, 10}, 1};
        const auto part = ball.partAlone(placement, Mode::Mip);
        const auto rest = ball.picture(Mode::Mip);
        ball.paste({placement});
        const auto both = ball.picture(Mode::Mip);
        int wrong = 0;
        int fromPart = 0;
        for (std::size_t i = 0; i < both.rgba.size(); ++i) {
            wrong += both.rgba[i] == std::max(part.rgba[i], rest.rgba[i]) ? 0 : 1;
            fromPart += part.rgba[i] > rest.rgba[i] ? 1 : 0;
        }
        EXPECT_EQ(wrong, 0);
        EXPECT_GT(fromPart, 1000);
    }
}

TEST_F(PartsTest, ANearerPartHidesAFartherOne) {
    CutBall ball(false);
    ball.look({0, 0, 0.8, {}, Projection::Orthographic}, {160, 128}); // looking along +y
    const auto rest = ball.picture(Mode::Surface);
    for (const double towards : {-40.0, 40.0}) {
        const Placement placement{{-8, towards, 3}, {}, 1};
        const auto part = ball.partAlone(placement, Mode::Surface);
        ball.paste({placement});
        const auto both = ball.picture(Mode::Surface);
        ball.frame.pasted.clear();
        const auto& near = towards < 0 ? part : rest;
        const auto& far = towards < 0 ? rest : part;
        int overlap = 0;
        int wrong = 0;
        for (int i = 0; i < both.width * both.height; ++i) {
            const int x = i % both.width;
            const int y = i / both.width;
            const auto& expected = isSeen(near, x, y) ? near : far;
            overlap += isSeen(near, x, y) && isSeen(far, x, y) ? 1 : 0;
            wrong += std::equal(both.pixel(x, y), both.pixel(x, y) + 4, expected.pixel(x, y)) ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0) << (towards < 0 ? "in front" : "behind");
        EXPECT_GT(overlap, 200);
    }
}

} // namespace
} // namespace vs::render

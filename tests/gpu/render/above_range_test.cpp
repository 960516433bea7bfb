// SPDX-License-Identifier: Apache-2.0
// Values above the displayed range count as its upper end in MIP and X-ray, or are hidden.
#include "gpu/gl_test.h"
#include "gpu/render/stage.h"
#include "image/compare.h"
#include "phantom/phantom.h"

namespace vs::render {
namespace {

using AboveRangeTest = test::GlTest;
using test::Stage;

constexpr glm::ivec2 kSize{120, 100};
constexpr double kRadius = 14;
const glm::dvec3 kCentre{23.5, 23.5, 23.5};
constexpr Range kShown{50, 100}; // the ball's inside is 200

volume::Volume brightBall() { return phantom::makeBall({48, 48, 48}, kCentre, kRadius, 200, 0, 3); }

// How far the ray through a pixel passes by the ball's centre, in voxels of 1 mm.
double miss(const Stage& stage, int x, int y) {
    const auto ray = stage.frame.rays.through({x + 0.5, y + 0.5});
    const glm::dvec3 centre(stage.volume.geometry.worldFromVoxel * glm::dvec4(kCentre, 1.0));
    const glm::dvec3 toCentre = centre - ray.origin;
    return glm::length(toCentre - glm::dot(toCentre, ray.direction) * ray.direction);
}

TEST_F(AboveRangeTest, ABallBrighterThanTheRangeIsAWhiteDisc) {
    Stage stage(brightBall(), kShown);
    stage.darken();
    stage.frame.scene.showsAbove = true;
    stage.look({20, 10}, kSize);
    const auto picture = stage.picture(Mode::Mip);
    int inside = 0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const double distance = miss(stage, x, y);
            if (distance < kRadius - 1) { // 100, the upper end, is met on the sphere itself
                EXPECT_EQ(picture.pixel(x, y)[0], 255) << x << ' ' << y;
                ++inside;
            } else if (distance > kRadius + 1.5) { // the ramp has fallen below the range
                EXPECT_LE(picture.pixel(x, y)[0], 1) << x << ' ' << y;
            }
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_EQ(image::compare(picture, stage.marchedPicture(Mode::Mip)).max, 0) << "skipping changes nothing";
}

// As if every value above the upper end were the upper end itself. Seen along walls between values, so that
// no ray crosses one, where interpolating before and after would differ.
TEST_F(AboveRangeTest, AnXRayCountsThemAsTheUpperEnd) {
    const auto halves = [](double left) {
        return phantom::makePhantom({48, 48, 48}, volume::ScalarType::UInt8,
                                    [=](glm::dvec3 p) { return p.x < 23.5 ? left : 75; });
    };
    Stage bright(halves(200), kShown);
    bright.frame.scene.showsAbove = true;
    Stage atTheEnd(halves(100), kShown);
    for (Stage* stage : {&bright, &atTheEnd}) {
        stage->darken();
        stage->look({0, 0, 1, {}, Projection::Orthographic}, kSize);
    }
    const auto picture = bright.picture(Mode::XRay);
    const auto expected = atTheEnd.picture(Mode::XRay);
    int compared = 0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const glm::dvec2 wall = bright.frame.rays.project(
                glm::dvec3(bright.volume.geometry.worldFromVoxel * glm::dvec4(23.5, 23.5, 23.5, 1)));
            if (std::abs(x + 0.5 - wall.x) * bright.frame.rays.pixelMm(glm::dvec3(0)) > 1.5) {
                EXPECT_LE(std::abs(picture.pixel(x, y)[0] - expected.pixel(x, y)[0]), 1) << x << ' ' << y;
                compared += expected.pixel(x, y)[0] > 50 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST_F(AboveRangeTest, HiddenTheyLeaveAShell) {
    Stage stage(brightBall(), kShown);
    stage.darken();
    stage.look({20, 10}, kSize);
    const auto through = [&](Mode mode) {
        return int(stage.picture(mode).pixel(kSize.x / 2, kSize.y / 2)[0]);
    };
    const int hidden = through(Mode::XRay);
    stage.frame.scene.showsAbove = true;
    EXPECT_GT(through(Mode::XRay), 4 * hidden + 20);
}

} // namespace
} // namespace vs::render

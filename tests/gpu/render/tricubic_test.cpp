// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "gpu/render/still.h"
#include "image/compare.h"
#include "phantom/phantom.h"
#include "reference/bspline.h"

#include <numbers>
#include <random>

namespace vs::render {
namespace {

using TricubicTest = test::GlTest;
using field::Sampling;
using test::Still;

// Single bright voxels far apart: what the B-spline makes of them reaches into macrocells all of whose voxels
// are dark.
volume::Volume makeStars() {
    std::mt19937 random(9);
    return phantom::makePhantom({61, 50, 45}, volume::ScalarType::UInt8,
                                [&](glm::dvec3) { return random() % 80 == 0 ? 255.0 : 0.0; }, {1, 1.3, 0.8});
}

TEST_F(TricubicTest, SkippingChangesNoPicture) {
    const Camera camera{40, 30, 1.2};
    for (const Mode mode : {Mode::Surface, Mode::Mip, Mode::XRay}) {
        // A star's values in the neighbouring cell are at most 255 / 6 * (2 / 3)^2 = 19.
        Still still(makeStars(), {12, 255}, camera, {160, 120}, Sampling::Tricubic);
        const auto skipping = still.picture(mode);
        still.skipNothing();
        const auto marching = still.picture(mode);
        const auto difference = image::compare(skipping, marching);
        // A ray that enters a cell by a hair's breadth may round to the neighbouring one.
        EXPECT_LT(difference.mean, 0.0005) << name(mode);
        EXPECT_LT(difference.changedFraction, 1e-4) << name(mode);
    }
}

TEST_F(TricubicTest, ABallLiesWhereTheBSplinePutsIt) {
    constexpr double radius = 20;
    // The B-spline blurs with a variance of 1/3 along each axis. Across a ramp that is straight along the
    // radius only the surface's curvature counts: it moves inward by variance / radius.
    constexpr double expected = radius - 1.0 / 3.0 / radius;
    const glm::dvec3 centre{31.3, 29.7, 33.1};
    Camera camera{25, 15, 1.8};
    camera.projection = Projection::Orthographic;
    Still still(phantom::makeBall({64, 64, 64}, centre, radius, 60000, 0, 10, volume::ScalarType::UInt16),
                {30000, 60000}, camera, {400, 400}, Sampling::Tricubic);

    std::vector<glm::vec2> pixels;
    for (int i = 0; i < 400 * 400; i += 7) {
        const glm::ivec2 pixel(i % 400, i / 400);
        pixels.push_back(glm::vec2(pixel) + 0.5F);
    }
    int hits = 0;
    for (const auto& point : still.picker.pickPoints(still.frame, pixels)) {
        if (point.voxel.w > 0.5F) {
            ++hits;
            const glm::dvec3 voxel(point.voxel);
            EXPECT_NEAR(glm::length(voxel - centre), expected, 0.004 + test::filterError());
            EXPECT_GT(glm::dot(glm::normalize(voxel - centre), glm::dvec3(point.normal)), 0.99998);
            EXPECT_NEAR(reference::bsplineAt(still.volume, voxel).value, 30000, 30);
        }
    }
    EXPECT_GT(hits, 1000);

    // The silhouette in the picture has the area of that ball's disc.
    const auto ball = still.picture(Mode::Surface);
    still.frame.scene.displayedRange = {70000, 80000};
    const auto nothing = still.picture(Mode::Surface);
    int covered = 0;
    for (int i = 0; i < 400 * 400; ++i) {
        const auto* a = ball.pixel(i % 400, i / 400);
        covered += std::equal(a, a + 3, nothing.pixel(i % 400, i / 400)) ? 0 : 1;
    }
    const double pixelMm = still.frame.rays.pixelMm(still.volume.geometry.centreWorld());
    EXPECT_NEAR(std::sqrt(covered / std::numbers::pi) * pixelMm, expected, 0.05);
}

TEST_F(TricubicTest, AVolumeOfOneValueIsSeenInFull) {
    const auto one =
        phantom::makePhantom({20, 20, 20}, volume::ScalarType::UInt8, [](glm::dvec3) { return 42.0; });
    Still still(one, {42, 42}, {}, {100, 100}, Sampling::Tricubic);
    Still linear(one, {42, 42}, {}, {100, 100});
    still.frame.scene.greyWindow = linear.frame.scene.greyWindow = {0, 255};
    for (const Mode mode : {Mode::Surface, Mode::Mip, Mode::XRay}) {
        EXPECT_EQ(image::compare(still.picture(mode), linear.picture(mode)).max, 0) << name(mode);
    }
}

TEST_F(TricubicTest, SamplingMayChangeBackAndForth) {
    Still still(makeStars(), {12, 255}, {40, 30, 1.2}, {160, 120});
    const auto linear = still.picture(Mode::Mip);
    still.input.sampling = still.frame.scene.sampling = Sampling::Tricubic;
    still.macrocells.rebuild(still.input);
    const auto cubic = still.picture(Mode::Mip);
    EXPECT_GT(image::compare(linear, cubic).mean, 5);
    Still fresh(makeStars(), {12, 255}, {40, 30, 1.2}, {160, 120}, Sampling::Tricubic);
    EXPECT_EQ(image::compare(cubic, fresh.picture(Mode::Mip)).max, 0);
    still.input.sampling = still.frame.scene.sampling = Sampling::Trilinear;
    still.macrocells.rebuild(still.input);
    EXPECT_EQ(image::compare(linear, still.picture(Mode::Mip)).max, 0);
}

} // namespace
} // namespace vs::render

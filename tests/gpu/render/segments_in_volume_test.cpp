// SPDX-License-Identifier: Apache-2.0
// Segments in the modes that can do without: as surfaces in volume mode, by their colours in MIP and X-ray.
#include "gpu/gl_test.h"
#include "gpu/render/segment_stage.h"
#include "image/compare.h"
#include "render/colours/function_edits.h"

#include <cmath>

namespace vs::render {
namespace {

using SegmentsInVolumeTest = test::GlTest;
using namespace test;

double ball(glm::dvec3 p) { return membership(p, kCentre, kOuter); }

// A stage whose transfer function shows what lies in 100 to 255, and no more of it than `opacity` a step.
struct VolumeStage : SegmentStage {
    explicit VolumeStage(const VoxelFunction& value = nothing) : SegmentStage(value) {
        classify(functionOfRange({100, 255}));
    }
};

TEST_F(SegmentsInVolumeTest, OpaqueOnesAreSurfacesAsInSegmentMode) {
    // With data in the segment and a little beyond it, which would hide it or lie on it as a crust.
    for (const double value : {0.0, 200.0}) {
        VolumeStage stage([=](glm::dvec3 p) { return glm::length(p - kCentre) < kOuter + 0.4 ? value : 0; });
        stage.colour(1, kRed);
        stage.segment(ball);
        const auto volume = stage.picture(Mode::Volume);
        SegmentStage alone;
        alone.colour(1, kRed);
        alone.segment(ball);
        const auto surface = alone.picture(Mode::Segment);
        for (const glm::vec2 pixel : allPixels(kSize, 1)) {
            const glm::dvec2 centre = stage.frame.rays.project(kCentre);
            const double pixels =
                glm::distance(glm::dvec2(pixel), centre) * stage.frame.rays.pixelMm(kCentre);
            if (pixels > 0.9 * kOuter && pixels < 1.1 * kOuter) {
                continue; // the outline, where a thin rim of data may be met beside the segment
            }
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(volume.pixel(int(pixel.x), int(pixel.y))[c],
                            surface.pixel(int(pixel.x), int(pixel.y))[c],
                            2) // linear light and back, dithered
                    << pixel.x << ' ' << pixel.y << " value " << value;
            }
        }
    }
}

TEST_F(SegmentsInVolumeTest, DataInFrontOfThemIsSeenThrough) {
    // A slab of fog on the viewer's side of the ball.
    VolumeStage stage([](glm::dvec3 p) { return p.y < 5 ? 200 : 0; });
    TransferFunction fog = functionOfRange({100, 255});
    for (auto& point : fog.points) {
        point.opacity *= 0.05;
    }
    stage.classify(fog);
    stage.look({0, 0, 1.2, {}, Projection::Orthographic}, kSize);
    stage.colour(1, kRed);
    stage.segment(ball);
    const auto picture = stage.picture(Mode::Volume);
    stage.frame.scene.segmentation = nullptr;
    const auto fogAlone = stage.picture(Mode::Volume);
    const auto* middle = picture.pixel(kSize.x / 2, kSize.y / 2);
    const auto* withoutBall = fogAlone.pixel(kSize.x / 2, kSize.y / 2);
    EXPECT_GT(middle[0], middle[2] + 60) << "the red ball is seen";
    EXPECT_GT(middle[2], 20) << "through the fog, which is white";
    EXPECT_GT(withoutBall[2], 20);
    EXPECT_LT(withoutBall[0], withoutBall[2] + 30) << "and the fog alone is not red";
}

TEST_F(SegmentsInVolumeTest, GlassShowsWhatIsInIt) {
    VolumeStage stage;
    stage.nest({glm::vec3(kRed), 0.4F}, kBlue);
    const auto picture = stage.picture(Mode::Volume);
    const glm::ivec2 centre(stage.frame.rays.project(kCentre));
    const auto* inner = picture.pixel(centre.x, centre.y);
    EXPECT_GT(inner[2], inner[0]) << "blue in red glass";
    EXPECT_GT(inner[0], 60);
    const double between = 0.5 * (kInner + kOuter) / stage.frame.rays.pixelMm(kCentre);
    const auto* glass = picture.pixel(centre.x + int(between), centre.y);
    EXPECT_GT(glass[0], 3 * glass[2]) << "beside it the glass alone";
    EXPECT_GT(glass[0], 60);
}

// Half of a bright ball is a segment: its half of the picture is red, the other as without.
TEST_F(SegmentsInVolumeTest, RaysAreTintedWhereTheyGoThroughThem) {
    for (const Mode mode : {Mode::Mip, Mode::XRay}) {
        SegmentStage stage([](glm::dvec3 p) { return 255 * membership(p, kCentre, kOuter); });
        stage.look({0, 0, 1.2, {}, Projection::Orthographic}, kSize);
        const auto plain = stage.picture(mode);
        stage.colour(1, kRed);
        stage.segment([](glm::dvec3 p) { return std::clamp(23.5 - p.x + 0.5, 0.0, 1.0) * ball(p); });
        const auto tinted = stage.picture(mode);
        const glm::dvec2 centre = stage.frame.rays.project(kCentre);
        int left = 0;
        for (const glm::vec2 pixel : allPixels(kSize, 1)) {
            const double radius =
                glm::distance(glm::dvec2(pixel), centre) * stage.frame.rays.pixelMm(kCentre);
            const double across = (pixel.x - centre.x) * stage.frame.rays.pixelMm(kCentre);
            const auto* before = plain.pixel(int(pixel.x), int(pixel.y));
            const auto* after = tinted.pixel(int(pixel.x), int(pixel.y));
            if (radius > kOuter + 3 || across > 2) {
                EXPECT_LE(std::abs(after[0] - before[0]), 1)
                    << name(mode) << ' ' << pixel.x << ' ' << pixel.y;
                EXPECT_LE(std::abs(after[2] - before[2]), 1)
                    << name(mode) << ' ' << pixel.x << ' ' << pixel.y;
            } else if (radius < kOuter - 3 && across < -2) {
                EXPECT_GT(after[0], 2 * after[2]) << name(mode) << ' ' << pixel.x << ' ' << pixel.y;
                EXPECT_GT(after[0], 0.7 * before[0]) << "as bright as before";
                ++left;
            }
        }
        EXPECT_GT(left, 300);
    }
}

} // namespace
} // namespace vs::render

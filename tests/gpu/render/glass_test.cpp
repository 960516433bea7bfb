// SPDX-License-Identifier: Apache-2.0
// Pictures of translucent segments against formulas.
#include "gpu/gl_test.h"
#include "gpu/render/segment_stage.h"
#include "image/compare.h"

#include <cmath>

namespace vs::render {
namespace {

using GlassTest = test::GlTest;
using namespace test;

// The nearer of the two surfaces of a ball around kCentre that a pixel's ray meets: the cosine between its
// normal and the way to the eye; 0 beside the ball.
double cosineAt(const ViewRays& rays, glm::dvec2 pixel, double radius) {
    const auto ray = rays.through(pixel);
    const glm::dvec3 toCentre = kCentre - ray.origin;
    const double along = glm::dot(toCentre, ray.direction);
    const double miss = glm::length(toCentre - along * ray.direction);
    return miss < radius ? std::sqrt(1 - miss * miss / (radius * radius)) : 0;
}

double opacityOfGlass(double opacity, double cosine) {
    return 1 - (1 - opacity) * (1 - std::pow(1 - cosine, 3));
}

TEST_F(GlassTest, GlassLiesOverWhatIsBehindIt) {
    constexpr float opacity = 0.4F;
    // In segment mode the data, which would be seen up to half a voxel further out, must not be.
    for (const auto& [mode, value] :
         {std::pair(Mode::Overlay, 0.0), std::pair(Mode::Segment, 0.0), std::pair(Mode::Segment, 200.0)}) {
        SegmentStage stage(
            [v = value](glm::dvec3 p) { return glm::length(p - kCentre) < kOuter + 0.5 ? v : 0; });
        stage.nest({glm::vec3(kRed), opacity}, kBlue);
        const auto both = stage.picture(mode);
        SegmentStage opaque;
        opaque.segment([](glm::dvec3 p) { return membership(p, kCentre, kInner); });
        const auto inner = opaque.pictureIn(kBlue, mode);
        opaque.segment([](glm::dvec3 p) { return membership(p, kCentre, kOuter); });
        const auto outer = opaque.pictureIn(kRed, mode);
        for (const glm::vec2 pixel : allPixels(kSize, 1)) {
            const double cosine = cosineAt(stage.frame.rays, pixel, kOuter);
            if (cosine > 0 && cosine < 0.4) {
                continue; // near the outline normals are not those of a sphere, and much depends on them
            }
            const double a = cosine > 0 ? opacityOfGlass(opacity, cosine) : 0;
            const int x = int(pixel.x);
            const int y = int(pixel.y);
            for (int c = 0; c < 3; ++c) {
                const double expected = a * outer.pixel(x, y)[c] + (1 - a) * inner.pixel(x, y)[c];
                // Three pictures rounded to 8 bits and dithered, and a cosine to within a hundredth.
                EXPECT_NEAR(both.pixel(x, y)[c], expected, 3) << name(mode) << ' ' << x << ' ' << y;
            }
        }
    }
}

TEST_F(GlassTest, GlassHidesItsOpacityOfTheBackground) {
    SegmentStage stage;
    stage.colour(1, {glm::vec3(kRed), 0.4F});
    stage.segments(
        nothing, [](glm::dvec3 p) { return membership(p, kCentre, kOuter); }, [](glm::dvec3) { return 1; });
    stage.frame.background = backgroundFromName("transparent");
    for (const Mode mode : kModesWithSegments) {
        const auto picture = stage.picture(mode);
        int seen = 0;
        for (const glm::vec2 pixel : allPixels(kSize, 1)) {
            const double cosine = cosineAt(stage.frame.rays, pixel, kOuter);
            if (cosine > 0.4) {
                const int alpha = picture.pixel(int(pixel.x), int(pixel.y))[3];
                EXPECT_NEAR(alpha, 255 * opacityOfGlass(0.4, cosine), 2) << name(mode);
                ++seen;
            }
        }
        EXPECT_GT(seen, 1000);
        EXPECT_EQ(picture.pixel(1, 1)[3], 0);
    }
}

TEST_F(GlassTest, ACutFaceOfGlassIsAsOpaqueAsItSays) {
    SegmentStage stage;
    stage.look({90, 0, 1.2, {}, Projection::Orthographic}, kSize); // from the patient's left, on to the cut
    stage.cutAbove(23.5);
    stage.segments(
        nothing, [](glm::dvec3 p) { return membership(p, kCentre, kOuter); }, [](glm::dvec3) { return 1; });
    stage.frame.background = backgroundFromName("transparent");
    stage.colour(1, {glm::vec3(kRed), 0.4F});
    const auto picture = stage.picture(Mode::Segment);
    const auto* middle = picture.pixel(kSize.x / 2, kSize.y / 2);
    EXPECT_NEAR(middle[3], 0.4 * 255, 1);
    EXPECT_GT(middle[0], middle[2] + 30) << "its own colour";
}

// Two balls of glass around opaque ones, one straight behind the other.
TEST_F(GlassTest, OfPartsTheNearerGlassLiesOverTheFarther) {
    constexpr double opacity = 0.4;
    for (const double towards : {-40.0, 40.0}) {
        SegmentStage stage;
        stage.look({0, 0, 0.8, {}, Projection::Orthographic}, kSize); // looking along +y
        stage.nest({glm::vec3(kRed), float(opacity)}, kBlue);
        const auto one = stage.picture(Mode::Segment);
        const auto outer = [&] {
            SegmentStage whole;
            whole.frame.rays = stage.frame.rays;
            whole.segment([](glm::dvec3 p) { return membership(p, kCentre, kOuter); });
            return whole.pictureIn(kRed, Mode::Segment);
        }();
        stage.sculpt([](glm::dvec3) { return 1.0; });
        stage.paste({Placement{}, Placement{{0, towards, 0}, {}, 1}});
        const auto both = stage.picture(Mode::Segment);
        int rings = 0;
        for (const glm::vec2 pixel : allPixels(kSize, 1)) {
            const int x = int(pixel.x);
            const int y = int(pixel.y);
            const double cosine = cosineAt(stage.frame.rays, pixel, kOuter);
            const bool isInner = cosineAt(stage.frame.rays, pixel, kInner - 0.3) > 0;
            const bool isRing = cosine > 0.4 && cosineAt(stage.frame.rays, pixel, kInner + 0.3) == 0;
            const double a = opacityOfGlass(opacity, cosine);
            for (int c = 0; c < 3 && (isInner || isRing); ++c) {
                const double glass = a * outer.pixel(x, y)[c];
                const double expected = isInner ? one.pixel(x, y)[c] : glass + (1 - a) * glass;
                EXPECT_NEAR(both.pixel(x, y)[c], expected, isInner ? 1 : 3) << x << ' ' << y;
            }
            rings += isRing ? 1 : 0;
        }
        EXPECT_GT(rings, 500);
    }
}

TEST_F(GlassTest, SkippingChangesNoPictureOfGlass) {
    SegmentStage stage([](glm::dvec3 p) { return 60 + 2 * p.z; });
    stage.nest({glm::vec3(kRed), 0.4F}, kBlue);
    stage.sculpt([](glm::dvec3 p) {
        return std::clamp(0.5 + glm::dot(p - kCentre, glm::dvec3(0.2, -0.3, 0.1)), 0.0, 1.0);
    });
    stage.darken();
    for (const Mode mode : kModesWithSegments) {
        for (const auto view : {field::SculptureView::Cut, field::SculptureView::Probe}) {
            stage.view(view);
            const auto difference = image::compare(stage.picture(mode), stage.marchedPicture(mode));
            EXPECT_LT(difference.mean, 0.05) << name(mode) << ": grey levels";
            EXPECT_LT(difference.changedFraction, 0.001) << name(mode);
        }
    }
}

TEST_F(GlassTest, GlassBlocksNoLight) {
    SegmentStage stage([](glm::dvec3 p) { return glm::length(p - kCentre) < kOuter + 0.5 ? 200 : 0; });
    const auto ball = [](glm::dvec3 p) { return membership(p, kCentre, kOuter); };
    for (const bool isGlass : {false, true}) {
        stage.segments(isGlass ? nothing : Stage::VoxelFunction(ball),
                       isGlass ? ball : Stage::VoxelFunction(nothing), [](glm::dvec3) { return 1; });
        OcclusionVolume::Input input;
        input.scene = stage.frame.scene;
        input.drawsSegmentation = true;
        for (const bool drawsData : {false, true}) {
            input.drawsData = drawsData;
            OcclusionVolume occlusion;
            occlusion.rebuild(input);
            int most = 0;
            for (const std::byte texel : occlusion.texels().downloadAll<std::byte>()) {
                most = std::max(most, int(texel));
            }
            if (isGlass) { // texels at its surface hold some of the data and are partly clear of it
                EXPECT_LE(most, drawsData ? 0.15 * 255 : 0);
            } else {
                EXPECT_EQ(most, 255);
            }
        }
    }
}

TEST_F(GlassTest, StrokesLandOnGlass) {
    SegmentStage stage;
    stage.nest({glm::vec3(kRed), 0.4F}, kBlue);
    for (const Mode mode : kModesWithSegments) {
        stage.frame.mode = mode;
        stage.rebuild();
        const auto points = stage.points({glm::vec2(kSize) * 0.5F});
        ASSERT_EQ(points.front().voxel.w, 1.0F) << name(mode);
        EXPECT_NEAR(glm::length(glm::dvec3(points.front().voxel) - kCentre), kOuter, 0.05) << name(mode);
    }
}

} // namespace
} // namespace vs::render

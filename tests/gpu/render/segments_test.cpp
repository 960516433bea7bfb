// SPDX-License-Identifier: Apache-2.0
// Pictures of several segments: whose colour is where.
#include "gpu/gl_test.h"
#include "gpu/render/segment_stage.h"
#include "image/compare.h"

#include <cmath>

namespace vs::render {
namespace {

using SegmentsTest = test::GlTest;
using namespace test;

// How far a pixel is from another, and from the straight way between two.
int apart(const std::uint8_t* a, const std::uint8_t* b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

bool isBetween(const std::uint8_t* p, const std::uint8_t* a, const std::uint8_t* b) {
    bool is = true;
    for (int c = 0; c < 3; ++c) {
        is = is && p[c] >= std::min(a[c], b[c]) - 1 && p[c] <= std::max(a[c], b[c]) + 1;
    }
    return is;
}

TEST_F(SegmentsTest, EachBallHasItsColour) {
    const glm::dvec3 left(13, 23.5, 23.5);
    const glm::dvec3 right(35, 23.5, 23.5);
    SegmentStage stage;
    stage.segments([=](glm::dvec3 p) { return std::max(membership(p, left, 8), membership(p, right, 8)); },
                   nothing, [](glm::dvec3 p) { return p.x < 24 ? 7 : 255; });
    stage.colour(7, kRed);
    stage.colour(255, kBlue);
    for (const Mode mode : kModesWithSegments) {
        const auto red = stage.pictureIn(kRed, mode);
        const auto blue = stage.pictureIn(kBlue, mode);
        const auto both = stage.picture(mode);
        const glm::dvec2 middle = stage.frame.rays.project(0.5 * (left + right));
        int seen = 0;
        for (const glm::vec2 pixel : allPixels(kSize, 1)) {
            const int x = int(pixel.x);
            const int y = int(pixel.y);
            // From in front the patient's left, which is where x grows, is on the picture's right.
            const auto* expected = pixel.x < middle.x ? red.pixel(x, y) : blue.pixel(x, y);
            EXPECT_LE(apart(both.pixel(x, y), expected), 1) << name(mode) << ' ' << x << ' ' << y;
            seen += apart(red.pixel(x, y), blue.pixel(x, y)) > 50 ? 1 : 0;
        }
        EXPECT_GT(seen, 1500);
    }
}

TEST_F(SegmentsTest, BordersBlendOverAVoxel) {
    constexpr double border = 23.5; // between voxels 23 and 24
    SegmentStage stage;
    stage.segments([](glm::dvec3 p) { return membership(p, kCentre, kOuter); }, nothing,
                   [](glm::dvec3 p) { return p.x < border ? 1 : 2; });
    stage.colour(1, kRed);
    stage.colour(2, kBlue);
    const auto red = stage.pictureIn(kRed, Mode::Overlay);
    const auto blue = stage.pictureIn(kBlue, Mode::Overlay);
    const auto both = stage.picture(Mode::Overlay);
    const auto pixels = allPixels(kSize, 1);
    const auto points = stage.points(pixels);
    int mixed = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int x = int(pixels[i].x);
        const int y = int(pixels[i].y);
        const double beside = points[i].voxel.x - border;
        if (points[i].voxel.w < 0.5F) {
            continue;
        }
        EXPECT_TRUE(isBetween(both.pixel(x, y), red.pixel(x, y), blue.pixel(x, y))) << x << ' ' << y;
        if (std::abs(beside) > 0.51) { // a hundredth of a voxel for where the surface was found
            const auto* expected = beside < 0 ? red.pixel(x, y) : blue.pixel(x, y);
            EXPECT_LE(apart(both.pixel(x, y), expected), 1) << x << ' ' << y;
        } else {
            mixed +=
                apart(both.pixel(x, y), red.pixel(x, y)) > 5 && apart(both.pixel(x, y), blue.pixel(x, y)) > 5;
        }
    }
    EXPECT_GT(mixed, 50) << "a line of pixels at the least";
}

TEST_F(SegmentsTest, NoColourComesFromHiddenSegmentsOrFromOutside) {
    SegmentStage stage;
    const auto ball = [](glm::dvec3 p) { return membership(p, kCentre, kOuter); };
    for (const double labelled :
         {kOuter, kOuter - 0.8}) {        // a smooth surface lies a little outside its voxels
        for (const int around : {0, 2}) { // no segment, and a hidden one
            stage.segments(ball, nothing,
                           [=](glm::dvec3 p) { return glm::length(p - kCentre) <= labelled ? 1 : around; });
            const auto expected = stage.pictureIn(kRed, Mode::Overlay);
            stage.colour(0, kBlue);
            stage.colour(1, kRed);
            stage.colour(2, glm::vec4(glm::vec3(kBlue), 0));
            EXPECT_LE(image::compare(stage.picture(Mode::Overlay), expected).max, 1)
                << "labels to " << labelled << ", around them " << around;
        }
    }
    stage.segments(ball, nothing, nothing);
    EXPECT_LE(image::compare(stage.picture(Mode::Overlay), stage.pictureIn(kBlue, Mode::Overlay)).max, 1)
        << "without labels the first entry's";
}

TEST_F(SegmentsTest, WithoutLabelsEverythingIsSegmentOne) {
    SegmentStage stage;
    stage.segment([](glm::dvec3 p) { return membership(p, kCentre, kOuter); });
    const auto expected = stage.pictureIn(kBlue, Mode::Overlay);
    stage.frame.segmentColours.entries.fill(kRed);
    stage.colour(1, kBlue);
    EXPECT_EQ(image::compare(stage.picture(Mode::Overlay), expected).max, 0);
}

} // namespace
} // namespace vs::render

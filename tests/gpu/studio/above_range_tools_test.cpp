// SPDX-License-Identifier: Apache-2.0
// Strokes in MIP and X-ray, where values above the displayed range are visible too: where tools begin, where
// seeds land, and what they take along.
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "studio/state/region.h"
#include "test_head.h"

#include <algorithm>
#include <numeric>

namespace vs::studio {
namespace {

using AboveRangeToolsTest = test::GlTest;

constexpr double kRadius = 16;
constexpr Range kShown{50, 100}; // the ball's inside is 200

volume::Volume brightBall() { return phantom::makeBall({64, 64, 64}, glm::dvec3(31.5), kRadius, 200, 0, 2); }

Canvas canvasIn(render::Mode mode, Range range = kShown) {
    Canvas canvas = test::testCanvas(range);
    canvas.view.mode = mode;
    return canvas;
}

Seed seedInTheMiddle(const Canvas& canvas) {
    Seed seed;
    seed.strokes = {test::ellipseAt(200, 150, 12, 9)};
    seed.canvas = canvas;
    return seed;
}

const Seed& lastSeed(const Document& document) { return std::get<Seed>(document.log().back()); }

std::size_t voxelsFrom(const volume::Volume& volume, double lo) {
    std::size_t count = 0;
    const glm::ivec3 dims = volume.geometry.dims;
    for (glm::ivec3 v(0); v.z < dims.z; ++v.z) {
        for (v.y = 0; v.y < dims.y; ++v.y) {
            for (v.x = 0; v.x < dims.x; ++v.x) {
                count += volume.at(v) >= lo ? 1 : 0;
            }
        }
    }
    return count;
}

// The same surface of the displayed range as in X-ray, not wherever along its ray each element's greatest
// value lies.
TEST_F(AboveRangeToolsTest, ToolsInMipCutWhatTheyCutInXRay) {
    std::vector<std::vector<std::byte>> cuts;
    for (const render::Mode mode : {render::Mode::XRay, render::Mode::Mip}) {
        Document document(test::testHead());
        Laser laser;
        laser.mask = test::ellipseAt(150, 150, 14, 12);
        laser.canvas = canvasIn(mode, {50, 120});
        document.apply(test::drillOf(test::ellipseAt(230, 150, 14, 12), canvasIn(mode, {50, 120})));
        document.apply(laser);
        Peel peel = test::somePeel(4);
        peel.canvas = canvasIn(mode, {50, 120});
        document.apply(peel);
        cuts.push_back(test::sculptureBytes(document));
    }
    EXPECT_TRUE(cuts[0] == cuts[1]);
}

TEST_F(AboveRangeToolsTest, SeedsInMipLieAtTheMaximum) {
    // A bright bead inside a dimmer ball: seen in MIP, behind the surface.
    Document document(phantom::makePhantom({64, 64, 64}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        const double r = glm::length(p - glm::dvec3(31.5));
        return r < 4 ? 200 : r < kRadius ? 80 : 0;
    }));
    for (const Range range : {Range{50, 255}, kShown}) {
        document.apply(seedInTheMiddle(canvasIn(render::Mode::Mip, range)));
        for (const glm::ivec3 voxel : lastSeed(document).voxels) {
            EXPECT_GE(document.volume().at(voxel), 199) << "up to " << range.hi;
        }
        document.apply(ReSeed{});
    }
}

TEST_F(AboveRangeToolsTest, SeedsGrowInAllThatIsVisible) {
    for (const render::Mode mode : {render::Mode::Mip, render::Mode::XRay, render::Mode::Overlay}) {
        Document document(brightBall());
        document.apply(seedInTheMiddle(canvasIn(mode)));
        ASSERT_FALSE(lastSeed(document).voxels.empty()) << render::name(mode);
        EXPECT_EQ(lastSeed(document).range->lo, kShown.lo);
        EXPECT_EQ(lastSeed(document).range->hi, document.volume().range.hi);
        document.apply(Grow{});
        EXPECT_EQ(document.region().voxelCount(1), voxelsFrom(document.volume(), kShown.lo))
            << render::name(mode);
    }
}

TEST_F(AboveRangeToolsTest, SeedsLandOnACutFaceWithinTheBall) {
    for (const render::Mode mode : {render::Mode::Mip, render::Mode::XRay}) {
        Document document(brightBall());
        Drill drill = test::drillOf(test::ellipseAt(200, 150, 20, 20), canvasIn(mode));
        drill.depthMax = 12;
        document.apply(drill);
        EXPECT_TRUE(!document.sculpture().isEmpty());
        document.apply(seedInTheMiddle(canvasIn(mode)));
        const auto& voxels = lastSeed(document).voxels;
        ASSERT_FALSE(voxels.empty()) << render::name(mode);
        const double deepest =
            std::accumulate(voxels.begin(), voxels.end(), kRadius, [](double least, glm::ivec3 voxel) {
                return std::min(least, glm::length(glm::dvec3(voxel) - glm::dvec3(31.5)));
            });
        EXPECT_LT(deepest, kRadius - 6)
            << "in the ball, where values lie above the range, in " << render::name(mode);
    }
}

TEST_F(AboveRangeToolsTest, HiddenAboveIsTheOldWay) {
    Document document(brightBall());
    Canvas canvas = canvasIn(render::Mode::XRay);
    canvas.view.hidesAbove = true;
    document.apply(seedInTheMiddle(canvas));
    EXPECT_EQ(lastSeed(document).range->hi, kShown.hi);
    for (const glm::ivec3 voxel : lastSeed(document).voxels) {
        EXPECT_LE(document.volume().at(voxel), kShown.hi);
    }
    document.apply(Grow{});
    EXPECT_LT(document.region().voxelCount(1), voxelsFrom(document.volume(), kShown.hi) / 2)
        << "the ball's edge only";
}

} // namespace
} // namespace vs::studio

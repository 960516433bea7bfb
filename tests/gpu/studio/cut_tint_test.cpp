// SPDX-License-Identifier: Apache-2.0
// The tint of segments on cut faces: a ball's is the disc that the plane cuts out of it, whether the ball was
// grown before or after the cut.
#include "gpu/gl_test.h"
#include "gpu/studio/cut_ball.h"
#include "image/compare.h"
#include "render/slices/slice_renderer.h"
#include "studio/state/region.h"

namespace vs::studio {
namespace {

using CutTintTest = test::GlTest;
using test::apart;
using test::Ball;
using test::CutBall;
using test::kBlue;
using test::kPicture;
using test::kRed;
using test::misfit;
using test::Order;
using test::Plane;
using test::stateOf;

const Plane kPlanes[] = {{0, 0, 0.4},    {0, 0, 9},      {33, 21, -0.3}, {33, 21, 10},   {33, 21, -10},
                         {45, 35.26, 0}, {45, 35.26, 8}, {-70, 58, -8},  {12, 80, 12.5}, {160, -30, 6}};
constexpr Order kOrders[] = {Order::GrownThenCut, Order::CutThenGrown};
constexpr double kNoticeable = 12; // of 255

// How much tinted pixels differ of those that look like the face's middle without tint.
int tintSpread(const image::Image& seen, const image::Image& without) {
    int least = 255;
    int most = 0;
    for (int y = 0; y < kPicture.y; ++y) {
        for (int x = 0; x < kPicture.x; ++x) {
            const int asInTheMiddle =
                without.pixel(x, y)[2] - without.pixel(kPicture.x / 2, kPicture.y / 2)[2];
            if (apart(seen, without, x, y) > kNoticeable && std::abs(asInTheMiddle) <= 1) {
                least = std::min(least, int(seen.pixel(x, y)[2]));
                most = std::max(most, int(seen.pixel(x, y)[2]));
            }
        }
    }
    return most - least;
}

void expectDisc(const Ball& ball, const Plane& plane, Order order, double tolerance) {
    const std::string what =
        fmt::format("azimuth {} elevation {} offset {} {}{}", plane.azimuthDegrees, plane.elevationDegrees,
                    plane.offsetMm, order == Order::CutThenGrown ? "cut, then grown" : "grown, then cut",
                    plane.isProbed ? ", in probe view" : "");
    CutBall cut(ball, plane, order);
    const auto before = stateOf(cut.document);
    const auto seen = cut.picture();
    EXPECT_TRUE(stateOf(cut.document) == before) << "pictures change nothing: " << what;
    const auto without = cut.without();
    const auto off = misfit(
        cut, [&](int x, int y) { return apart(seen, without, x, y) > kNoticeable; }, ball.radiusMm);
    fmt::print("{}: beyond {:.2f} behind {:.2f}\n", what, off.beyond, off.behind);
    EXPECT_LT(off.beyond, tolerance) << what;
    EXPECT_LT(off.behind, tolerance) << what;
    EXPECT_LE(tintSpread(seen, without), 3) << "the segment's colour in full: " << what;
}

TEST_F(CutTintTest, IsTheDiscThatThePlaneCutsOutOfABall) {
    for (const Plane& plane : kPlanes) {
        for (const Order order : kOrders) {
            expectDisc({}, plane, order, 0.5);
        }
    }
}

TEST_F(CutTintTest, IsADiscInProbeViewToo) {
    for (Plane plane : {kPlanes[3], kPlanes[7]}) {
        plane.isProbed = true;
        expectDisc({}, plane, Order::CutThenGrown, 0.5);
    }
}

// There the face is the segment's own surface, and seen as such all over.
TEST_F(CutTintTest, CoversASegmentThatToolsSpared) {
    for (const Plane& plane : {Plane{0, 0, 0}, Plane{33, 21, 0}, Plane{45, 35.26, 0}}) {
        CutBall cut({}, plane, Order::GrownThenCut);
        cut.document.apply(Undo{});
        UseSegment spare{"Segment 1"};
        spare.treatment = SegmentInfo::Treatment::Spare;
        cut.document.apply(spare);
        Clip all;
        all.box = Clip::Box{glm::dvec3(200), glm::dvec3(201)};
        cut.document.apply(all);
        const auto seen = cut.picture();
        const auto without = cut.without();
        const auto off = misfit(
            cut, [&](int x, int y) { return apart(seen, without, x, y) > kNoticeable; }, cut.ball.radiusMm);
        EXPECT_LT(off.beyond, 0.5);
        EXPECT_LT(off.behind, 0.5) << "neither holes nor a ragged rim";
    }
}

// A face is taken for the segment's own only where tools spared segments: a cavity that was cut out by the
// segment itself looks the same whether such a cut was ever made and undone, or cleared, or not.
TEST_F(CutTintTest, IsOfOthersOnlyWhereToolsSparedThem) {
    const auto cavity = [](bool wasSpared, auto&& takeBack) {
        CutBall cut({}, {33, 21, 0}, Order::GrownThenCut);
        cut.document.apply(Undo{});
        UseSegment spare{"Segment 1"};
        Clip all;
        all.box = Clip::Box{glm::dvec3(200), glm::dvec3(201)};
        if (wasSpared) {
            spare.treatment = SegmentInfo::Treatment::Spare;
            cut.document.apply(spare);
            cut.document.apply(all);
            takeBack(cut.document);
        }
        spare.treatment = SegmentInfo::Treatment::Take;
        cut.document.apply(spare);
        CutSegment ball;
        ball.keeps = false;
        cut.document.apply(ball);
        return cut.picture();
    };
    const auto plain = cavity(false, [](Document&) {});
    EXPECT_EQ(cavity(true, [](Document& document) { document.apply(Undo{}); }).rgba, plain.rgba);
    EXPECT_EQ(cavity(true, [](Document& document) { document.apply(UnCut{}); }).rgba, plain.rgba);
}

// Where between two slices a border is, their voxels do not say.
TEST_F(CutTintTest, IsADiscAcrossThickSlicesToo) {
    Ball ball;
    ball.dims = {64, 64, 22};
    ball.spacing = {1, 1, 3};
    for (const Plane& plane : kPlanes) {
        for (const Order order : kOrders) {
            expectDisc(ball, plane, order, 0.7);
        }
    }
}

TEST_F(CutTintTest, EachSegmentKeepsItsColour) {
    Ball ball;
    ball.innerMm = 12.3;
    for (const Plane& plane : {kPlanes[0], kPlanes[3], kPlanes[7]}) {
        for (const Order order : kOrders) {
            CutBall cut(ball, plane, order);
            const auto seen = cut.picture();
            const auto without = cut.without();
            const auto red = cut.in(kRed);
            const auto blue = cut.in(kBlue);
            const auto isTinted = [&](int x, int y) { return apart(seen, without, x, y) > kNoticeable; };
            const auto outer = misfit(cut, isTinted, ball.radiusMm);
            const auto inner = misfit(
                cut,
                [&](int x, int y) {
                    return isTinted(x, y) && apart(seen, blue, x, y) < apart(seen, red, x, y);
                },
                ball.innerMm);
            EXPECT_LT(outer.beyond, 0.5) << plane.azimuthDegrees << ' ' << int(order);
            EXPECT_LT(outer.behind, 0.5) << plane.azimuthDegrees << ' ' << int(order);
            // Between segments colours are blended from voxel to voxel, not smoothed. Behind a face that
            // both were grown up to there are none: half a voxel less to go by.
            const double border = order == Order::GrownThenCut ? 0.9 : 1.4;
            EXPECT_LT(inner.beyond, border) << plane.azimuthDegrees << ' ' << int(order);
            EXPECT_LT(inner.behind, border) << plane.azimuthDegrees << ' ' << int(order);
        }
    }
}

TEST_F(CutTintTest, GlassCoversTheDiscToo) {
    CutBall cut({}, {33, 21, -10}, Order::CutThenGrown);
    const auto without = cut.without();
    UseSegment glass{"Segment 1"};
    glass.opacity = 0.5;
    cut.document.apply(glass);
    for (const render::Mode mode : {render::Mode::Segment, render::Mode::Overlay}) {
        cut.look(mode);
        const auto seen = cut.picture();
        const auto bare = cut.without();
        const auto off = misfit(
            cut, [&](int x, int y) { return apart(seen, bare, x, y) > kNoticeable; }, cut.ball.radiusMm);
        EXPECT_LT(off.behind, 0.5) << render::name(mode);
    }
}

// In overlay mode a cap that narrows away from the viewer is its cut face.
TEST_F(CutTintTest, OverlayShowsTheDiscAlone) {
    CutBall cut({}, {33, 21, -10}, Order::CutThenGrown);
    cut.look(render::Mode::Overlay);
    const auto seen = cut.picture();
    const auto without = cut.without();
    const auto off = misfit(
        cut, [&](int x, int y) { return apart(seen, without, x, y) > kNoticeable; }, cut.ball.radiusMm);
    EXPECT_LT(off.beyond, 0.5);
    EXPECT_LT(off.behind, 0.5);
}

TEST_F(CutTintTest, NothingIsLeftOfItWhenTheCutIsPutBack) {
    CutBall cut({}, {33, 21, 10}, Order::CutThenGrown);
    cut.picture();
    const auto labels = cut.document.region().labelMap();
    cut.document.apply(UnCut{});
    EXPECT_EQ(cut.document.region().labelMap(), labels);
    const auto seen = cut.picture();
    CutBall never({}, {33, 21, 10}, Order::CutThenGrown); // no picture of it was made while it was cut
    never.document.apply(UnCut{});
    EXPECT_EQ(image::compare(seen, never.picture()).max, 0);
    cut.document.apply(Undo{});
    never.document.apply(Undo{});
    EXPECT_EQ(image::compare(cut.picture(), never.picture()).max, 0) << "and it is there again";
}

// Growth in probe view ends at the cavity that its piece was taken out of.
TEST_F(CutTintTest, TheCavityOfAGrownPieceHasNoTint) {
    CutBall cut({}, {33, 21, 0.3, true}, Order::CutThenGrown);
    View view = cut.document.view();
    view.sculptureView = field::SculptureView::Cut;
    view.camera.azimuthDegrees += 180;
    view.camera.elevationDegrees *= -1;
    cut.document.showView(view);
    const auto seen = cut.picture();
    EXPECT_EQ(image::compare(seen, cut.without()).max, 0);
}

TEST_F(CutTintTest, APastedPieceHasTheTintOfItsOwnSideOnly) {
    CutBall cut({}, {33, 21, 0.3}, Order::CutThenGrown);
    View view = cut.document.view();
    view.camera.zoom = 0.5;
    const auto tinted = [&] {
        cut.document.showView(view);
        const auto seen = cut.picture();
        const auto without = cut.without();
        int pixels = 0;
        for (int y = 0; y < kPicture.y; ++y) {
            for (int x = 0; x < kPicture.x; ++x) {
                pixels += apart(seen, without, x, y) > kNoticeable ? 1 : 0;
            }
        }
        return pixels;
    };
    const int alone = tinted();
    EXPECT_GT(alone, 500);
    view.pasted = {{90.0 * glm::normalize(cut.rays().right), {0, 180, 0}}}; // its cut face to the viewer
    EXPECT_EQ(tinted(), alone);
}

TEST_F(CutTintTest, SlicesShowWhatHasGrown) {
    CutBall cut({}, {0, 0, 0.4}, Order::CutThenGrown); // what is before voxel 31 along y is cut away
    cut.picture();
    const volume::GridGeometry& grid = cut.document.volume().geometry;
    render::SliceView view{render::SliceKind::Axial, 31, {}, 0.5, {140, 140}};
    const render::SliceGeometry geometry(grid, view.kind);
    const auto slice = [&] {
        render::SliceRenderer renderer;
        renderer.render(cut.document.slice(view));
        return renderer.readPicture();
    };
    const auto seen = slice();
    const auto without = cut.with([](UseSegment& use) { use.isVisible = false; }, slice);
    const auto labels = cut.document.region().labelMap();
    int grown = 0;
    for (int y = 0; y < view.size.y; ++y) {
        for (int x = 0; x < view.size.x; ++x) {
            const glm::ivec3 voxel(
                glm::round(geometry.voxelAt(view.placeAt({x + 0.5, y + 0.5}), view.index)));
            const bool isOnGrid = glm::all(glm::greaterThan(voxel, glm::ivec3(0))) &&
                                  glm::all(glm::lessThan(voxel, grid.dims - 1));
            if (!isOnGrid) {
                continue;
            }
            bool isNearGrown = false;
            for (int i = 0; i < 9; ++i) {
                const glm::ivec3 beside = voxel + glm::ivec3(i % 3 - 1, i / 3 - 1, 0);
                isNearGrown =
                    isNearGrown ||
                    labels[(std::size_t(beside.z) * grid.dims.y + beside.y) * grid.dims.x + beside.x] != 0;
            }
            const bool isTinted = apart(seen, without, x, y) > kNoticeable;
            EXPECT_TRUE(!isTinted || isNearGrown) << x << ' ' << y;
            grown += isTinted ? 1 : 0;
        }
    }
    EXPECT_GT(grown, 1000);
}

} // namespace
} // namespace vs::studio

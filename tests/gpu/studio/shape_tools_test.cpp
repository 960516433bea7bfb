// SPDX-License-Identifier: Apache-2.0
// Scissors, clip boxes, what is kept connected, and parts that are pasted.
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_tools.h"
#include "studio/document/live_stroke.h"
#include "studio/document/part_queries.h"
#include "studio/document/surface_queries.h"

namespace vs::studio {
namespace {

TEST_F(ToolsTest, ScissorsCutWhatIsSeenInsideTheOutlineOrOutsideIt) {
    for (const bool outside : {false, true}) {
        Head document;
        Scissors op = scissorsAt(200, 150, 40);
        op.cutsOutside = outside;
        document.apply(op);
        for (int y = 20; y < 290; y += 9) {
            for (int x = 20; x < 390; x += 9) {
                const double r = glm::distance(glm::dvec2(x, y), glm::dvec2(200, 150));
                if (std::abs(r - 40) < 2) {
                    continue;
                }
                const bool isSeen = document.surface().probe({x, y}, {400, 300}).has_value();
                EXPECT_FALSE(isSeen && (r < 40) != outside) << x << " " << y;
            }
        }
        // On the plane across the view through the grid's centre the 0.5 level is the outline.
        const auto values = sculptureOf(document);
        const auto& geometry = document.volume().geometry;
        const auto rays = render::viewRays(op.canvas->view.camera, geometry, {400, 300});
        double worst = 0;
        for (double angle = 0; angle < 6.2; angle += 0.3) {
            const glm::dvec2 way(std::cos(angle), std::sin(angle));
            const auto at = [&](double r) {
                const auto ray = rays.through(glm::dvec2(200, 150) + r * way);
                const double t = glm::dot(geometry.centreWorld() - ray.origin, rays.forward) /
                                 glm::dot(ray.direction, rays.forward);
                const glm::dvec3 world = ray.origin + t * ray.direction;
                return test::sampleGrid(values, geometry.dims,
                                        glm::dvec3(geometry.voxelFromWorld() * glm::dvec4(world, 1.0)));
            };
            double lo = 30;
            double hi = 50;
            for (int n = 0; n < 40; ++n) {
                const double mid = 0.5 * (lo + hi);
                ((at(mid) >= 0.5F) != outside ? lo : hi) = mid;
            }
            worst = std::max(worst, std::abs(lo - 40) * rays.pixelMm(geometry.centreWorld()));
        }
        EXPECT_LT(worst, 0.2) << "mm";
    }
}

TEST_F(ToolsTest, AClipBoxCutsExactlyAtItsFaces) {
    Head document;
    Clip clip;
    clip.box = Clip::Box{{20.3, 10, 15}, {50, 60.25, 40}};
    document.apply(clip);
    const auto values = sculptureOf(document);
    const glm::ivec3 dims = document.volume().geometry.dims;
    const auto crossing = [&](glm::dvec3 from, glm::dvec3 way) {
        double lo = 0;
        double hi = 20;
        for (int n = 0; n < 40; ++n) {
            const double mid = 0.5 * (lo + hi);
            (test::sampleGrid(values, dims, from + mid * way) < 0.5F ? lo : hi) = mid;
        }
        return lo;
    };
    EXPECT_NEAR(crossing({30, 35, 27}, {-1, 0, 0}), 9.7, 0.05);
    EXPECT_NEAR(crossing({45, 35, 27}, {1, 0, 0}), 5, 0.05);
    EXPECT_NEAR(crossing({30, 45, 27}, {0, 1, 0}), 15.25, 0.05);
    EXPECT_NEAR(crossing({30, 35, 27}, {0, 0, 1}), 13, 0.05);
    // The rest is what a clip of the inside leaves.
    clip.cutsInside = true;
    document.apply(clip);
    const auto all = sculptureOf(document);
    EXPECT_GE(*std::min_element(all.begin(), all.end()), 0.49F);
}

TEST_F(ToolsTest, ALiveClipLeavesOnlyItsLastShape) {
    Clip clip;
    clip.planes = {{{35, 39, 30}, {0, 0, 1}}};
    Head live;
    live.stroke().begin(clip);
    for (const double z : {10.0, 50.0, 22.5}) {
        clip.planes[0].point.z = z;
        live.stroke().clipTo(clip);
    }
    live.stroke().commit();
    Head once;
    once.apply(clip);
    EXPECT_TRUE(test::sculptureBytes(live) == test::sculptureBytes(once));
}

// Two balls; the smaller one is the table.
volume::Volume twoBalls() {
    return phantom::makePhantom({64, 48, 48}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        const double a = 14 - glm::distance(p, {20, 24, 24});
        const double b = 6 - glm::distance(p, {48, 24, 24});
        return std::clamp(100 + 40 * std::max(a, b), 0.0, 200.0);
    });
}

TEST_F(ToolsTest, OnlyWhatIsConnectedToThePlaceUnderThePenIsKept) {
    Document document(twoBalls());
    KeepConnected op;
    op.canvas = testCanvas({100, 255});
    op.canvas->view.camera = {};
    const auto rays = render::viewRays({}, document.volume().geometry, {400, 300});
    op.pixel = rays.project({20, 24, 24});
    const glm::dvec2 other = rays.project({48, 24, 24});
    document.apply(SetView{op.canvas->view.camera, {}, Range{100, 255}, {}});
    const auto kept = document.surface().probe(*op.pixel, {400, 300});
    ASSERT_TRUE(kept && document.surface().probe(other, {400, 300}));
    EXPECT_GT(document.apply(op).voxelsTouched, 100U);
    EXPECT_FALSE(document.surface().probe(other, {400, 300}));
    const auto still = document.surface().probe(*op.pixel, {400, 300});
    ASSERT_TRUE(still);
    EXPECT_EQ(still->voxel, kept->voxel) << "its surface is as it was";
    // Nothing of the other is seen anywhere.
    for (int y = 0; y < 300; y += 3) {
        for (int x = 0; x < 400; x += 3) {
            const auto hit = document.surface().probe({x, y}, {400, 300});
            EXPECT_TRUE(!hit || hit->voxel.x < 36) << x << " " << y;
        }
    }
    // Replayed from the voxel that was found.
    const auto& logged = std::get<KeepConnected>(document.log().back());
    EXPECT_TRUE(logged.voxel.has_value());
    op.pixel = {1, 1};
    EXPECT_THROW(document.apply(op), Error);
    document.apply(Undo{});
    EXPECT_TRUE(document.surface().probe(other, {400, 300}));
}

// Where parts are seen: pixels of the pictures of each.
TEST_F(ToolsTest, EachPasteIsAPartOfItsOwn) {
    Head document;
    EXPECT_THROW(document.apply(Paste{}), Error) << "nothing was cut yet";
    document.apply(scissorsAt(170, 130, 15));
    document.apply(Paste{{{200, 0, 0}, {}, 1}});
    const Box3 grid = document.volume().geometry.box();
    const auto part = [&](std::size_t k) {
        const auto frame = document.frame({400, 300});
        const auto bytes = frame.pasted.at(k).sculpture->download(grid);
        return sculpt::valuesOf(bytes, sculpt::Precision::Bits16);
    };
    const auto first = part(0);
    EXPECT_TRUE(first == sculptureOf(document));
    document.apply(scissorsAt(230, 130, 15));
    EXPECT_TRUE(part(0) == sculptureOf(document)) << "until the next paste it takes in what is cut";
    document.apply(Paste{{{-200, 0, 0}, {}, 1}});
    EXPECT_EQ(document.parts().count(), 2U);
    EXPECT_TRUE(part(0) == first) << "then it is what it was";
    const auto second = part(1);
    const auto all = sculptureOf(document);
    for (std::size_t n = 0; n < all.size(); ++n) {
        EXPECT_EQ(all[n] > 0.501F, first[n] > 0.501F || second[n] > 0.501F);
        EXPECT_FALSE(first[n] > 0.501F && second[n] > 0.501F);
    }
    // Live: what is put back leaves its part.
    document.apply(restoring(scissorsAt(170, 130, 30)));
    const auto rest = part(0);
    EXPECT_LT(*std::max_element(rest.begin(), rest.end()), 0.5F);
    document.apply(Undo{});
    EXPECT_TRUE(part(0) == first);
    document.apply(MovePart{0, {{100, 0, 0}, {0, 0, 45}, 0.5}});
    EXPECT_EQ(document.view().pasted.at(0).scale, 0.5);
    document.apply(Undo{});
    EXPECT_EQ(document.view().pasted.at(0).moveMm.x, 200);
    document.apply(Undo{});
    EXPECT_EQ(document.view().pasted.size(), 1U);
    document.apply(Redo{});
    EXPECT_TRUE(part(1) == second);
    document.apply(UnCut{});
    EXPECT_EQ(document.parts().count(), 0U);
    document.apply(Undo{});
    EXPECT_EQ(document.parts().count(), 2U);
    EXPECT_TRUE(part(1) == second);
    EXPECT_THROW(document.apply(MovePart{2, {}}), Error);
}

// The window looks about between edits without logging it.
TEST_F(ToolsTest, ALogReplaysToTheSamePartsAfterUndo) {
    Head document;
    document.apply(scissorsAt(170, 130, 15));
    View view = document.view();
    view.camera.azimuthDegrees = 30;
    document.showView(view);
    document.apply(Paste{{{90, 0, 0}, {}, 1}});
    document.apply(Undo{});
    Head again;
    for (const Operation& operation : document.log()) {
        again.apply(operation);
    }
    EXPECT_EQ(again.view().pasted.size(), 0U);
    EXPECT_EQ(again.view(), document.view());
}

TEST_F(ToolsTest, SketchesFarBeyondThePictureCutAsTheirPartInIt) {
    Head near;
    Scissors op = scissorsAt(200, 130, 15);
    op.outline = {Shape::Rectangle, {{-200, 100}, {500, 140}}};
    near.apply(op);
    Head far;
    op.outline = {Shape::Rectangle, {{-9e5, 100}, {9e5, 140}}};
    far.apply(op);
    EXPECT_TRUE(test::sculptureBytes(near) == test::sculptureBytes(far));
}

} // namespace
} // namespace vs::studio

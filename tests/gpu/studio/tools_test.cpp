// SPDX-License-Identifier: Apache-2.0
// What every tool promises, whatever it cuts (doc/behaviour.md, "Tools").
#include "gpu/gl_test.h"
#include "gpu/sculpt/surface_makers.h"
#include "test_head.h"

#include "base/error.h"
#include "gpu/studio/sculpture_bytes.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_stroke.h"
#include "studio/document/part_queries.h"
#include "studio/document/surface_queries.h"
#include "studio/state/region.h"

#include <cmath>

namespace vs::studio {
namespace {

using ToolsTest = test::GlTest;
using test::ellipseAt;
using test::testCanvas;
using test::testHead;

// A document of the head that looks as strokes are drawn.
struct Head : Document {
    Head() : Document(testHead()) { look(testCanvas().view); }
};

template <typename Pen>
Pen penAt(double x, double y, double radius, sculpt::Stroke stroke = {}) {
    Pen op;
    op.mask = ellipseAt(x, y, radius, radius);
    op.stroke = stroke.empty() ? sculpt::Stroke{{{x, y}, 1}} : std::move(stroke);
    op.depthMax = 9;
    op.canvas = testCanvas();
    return op;
}

Sweep sweepAcross(double x, double y) {
    Sweep op;
    op.mask = ellipseAt(x, y, 6, 6);
    op.path.kind = SweepPath::Kind::Surface;
    op.path.stroke = {{x - 15, y}, {x, y + 3}, {x + 15, y}};
    op.canvas = testCanvas();
    return op;
}

Scissors scissorsAt(double x, double y, double radius) {
    Scissors op;
    op.outline = ellipseAt(x, y, radius, radius);
    op.canvas = testCanvas();
    return op;
}

Peel peelAt(double x, double y, double radius) {
    Peel op = test::somePeel(6);
    op.mask = ellipseAt(x, y, radius, radius);
    return op;
}

// Each tool, drawn about a place.
std::vector<Operation> toolsAt(double x, double y) {
    Scissors shallow = scissorsAt(x, y, 10);
    shallow.depth = 5;
    return {peelAt(x, y, 12),  penAt<Drill>(x, y, 10), penAt<Laser>(x, y, 10),
            sweepAcross(x, y), scissorsAt(x, y, 10),   shallow};
}

Operation restoring(Operation operation) {
    std::visit(
        [](auto& op) {
            if constexpr (requires { op.restores; }) {
                op.restores = true;
            }
        },
        operation);
    return operation;
}

std::vector<float> sculptureOf(const Document& document) {
    return sculpt::valuesOf(test::sculptureBytes(document), sculpt::Precision::Bits16);
}

TEST_F(ToolsTest, UndoAndRedoGiveEveryByteBack) {
    for (const Operation& tool : toolsAt(200, 130)) {
        Head document;
        const auto untouched = test::sculptureBytes(document);
        EXPECT_GT(document.apply(tool).voxelsTouched, 100U) << name(tool);
        const auto once = test::sculptureBytes(document);
        document.apply(Undo{});
        EXPECT_TRUE(test::sculptureBytes(document) == untouched) << name(tool);
        document.apply(Redo{});
        EXPECT_TRUE(test::sculptureBytes(document) == once) << name(tool);
    }
}

// A new stroke sees the surface that the one before left; what does not follow the surface, and the same way
// gone twice in one stroke, changes nothing.
TEST_F(ToolsTest, TheSameTwiceIsTheSameOnce) {
    Sweep helix;
    helix.mask = {Shape::Ellipse, {{-4, -3}, {4, 3}}};
    helix.path.kind = SweepPath::Kind::Helix;
    helix.path.points = {{36, 40, 10}, {36, 40, 50}};
    helix.path.helixRadius = 15;
    helix.path.turns = 2;
    Clip clip;
    clip.box = Clip::Box{{10, 10, 10}, {50, 50, 50}};
    for (const Operation& tool : std::vector<Operation>{scissorsAt(200, 130, 20), helix, clip}) {
        Head document;
        EXPECT_GT(document.apply(tool).voxelsTouched, 100U) << name(tool);
        EXPECT_EQ(document.apply(tool).voxelsTouched, 0U) << name(tool);
    }
    const sculpt::Stroke there{{{180, 130}, 0.6}, {{215, 134}, 1}};
    const sculpt::Stroke andBack{{{180, 130}, 0.6}, {{215, 134}, 1}, {{180, 130}, 0.6}, {{215, 134}, 1}};
    Head once;
    once.apply(penAt<Drill>(180, 130, 9, there));
    Head twice;
    twice.apply(penAt<Drill>(180, 130, 9, andBack));
    const auto a = sculptureOf(once);
    const auto b = sculptureOf(twice);
    for (std::size_t n = 0; n < a.size(); ++n) {
        ASSERT_NEAR(a[n], b[n], 0.02);
    }
}

TEST_F(ToolsTest, BesideTheVolumeNothingHappens) {
    for (const Operation& tool : toolsAt(8, 8)) {
        Head document;
        const Outcome outcome = document.apply(tool);
        if (std::holds_alternative<Scissors>(tool) && !std::get<Scissors>(tool).depth) {
            continue; // cuts the air there
        }
        EXPECT_EQ(outcome.voxelsTouched, 0U) << name(tool);
        EXPECT_FALSE(document.facts()->canUndo()) << name(tool);
    }
}

TEST_F(ToolsTest, EmptySketchesAndNoPressureDoNothing) {
    Drill drill = penAt<Drill>(200, 130, 10, {{{200, 130}, 0}, {{220, 130}, 0}});
    Laser laser = penAt<Laser>(200, 130, 10, {{{200, 130}, 0}, {{220, 130}, 0}});
    Peel peel = peelAt(200, 130, 10);
    peel.mask = {Shape::FreeForm, {}};
    Scissors scissors = scissorsAt(200, 130, 10);
    scissors.outline = {Shape::FreeForm, {{1, 1}, {50, 50}}};
    Sweep still = sweepAcross(200, 130);
    still.path.stroke = {{200, 130}, {200, 130}};
    for (const Operation& tool : std::vector<Operation>{drill, laser, peel, scissors, still}) {
        Head document;
        EXPECT_EQ(document.apply(tool).voxelsTouched, 0U) << name(tool);
    }
}

TEST_F(ToolsTest, HoldingThePenStillChangesNothingMore) {
    for (Operation tool : std::vector<Operation>{penAt<Drill>(200, 130, 10), penAt<Laser>(200, 130, 10)}) {
        Head document;
        document.stroke().begin(tool);
        document.stroke().drawAt({{200, 130}, 0.8});
        const auto once = test::sculptureBytes(document);
        for (int n = 0; n < 3; ++n) {
            document.stroke().drawAt({{200, 130}, 0.8});
        }
        EXPECT_TRUE(test::sculptureBytes(document) == once) << name(tool);
        EXPECT_GT(document.stroke().commit().voxelsTouched, 100U);
    }
}

TEST_F(ToolsTest, TheOrderOfDisjointStrokesDoesNotMatter) {
    const auto left = toolsAt(165, 140);
    const auto right = toolsAt(240, 140);
    for (std::size_t n = 0; n < left.size(); ++n) {
        Head a;
        a.apply(left[n]);
        a.apply(right[n]);
        Head b;
        b.apply(right[n]);
        b.apply(left[n]);
        EXPECT_TRUE(test::sculptureBytes(a) == test::sculptureBytes(b)) << name(left[n]);
    }
}

// Nothing of a cut remains visible when the same stroke puts it back. Strokes that follow what they see see
// the cut's floor now, so they are given room to come up again.
TEST_F(ToolsTest, RestoreAfterCutLeavesNothingBehind) {
    auto tools = toolsAt(200, 130);
    Sweep across = sweepAcross(0, 0); // on a way that does not depend on what is seen
    across.mask = {Shape::Ellipse, {{-5, -5}, {5, 5}}};
    across.path = {SweepPath::Kind::Spline, {}, {{20, 20, 40}, {36, 12, 45}, {50, 20, 40}}};
    std::replace_if(
        tools.begin(), tools.end(), [](const auto& op) { return std::holds_alternative<Sweep>(op); }, across);
    for (const Operation& tool : tools) {
        Head document;
        document.apply(tool);
        const auto before = sculptureOf(document);
        Operation back = restoring(tool);
        std::visit(
            [](auto& op) {
                using Op = std::decay_t<decltype(op)>;
                if constexpr (std::is_same_v<Op, Peel>) {
                    op.layers = 40;
                    op.mask = ellipseAt(200, 130, 24, 24);
                } else if constexpr (std::is_same_v<Op, Drill> || std::is_same_v<Op, Laser>) {
                    op.depthMax = 40;
                    op.mask = ellipseAt(200, 130, 22, 22);
                } else if constexpr (std::is_same_v<Op, Scissors>) {
                    op.outline = ellipseAt(200, 130, 14, 14);
                    op.depth = op.depth ? std::optional(40.0) : std::nullopt;
                }
            },
            back);
        EXPECT_GT(document.apply(back).voxelsTouched, 100U) << name(tool);
        const auto after = sculptureOf(document);
        const auto& volume = document.volume();
        int cut = 0;
        int left = 0;
        for (std::size_t n = 0; n < after.size(); ++n) {
            const bool isObject = std::to_integer<int>(volume.bytes[n]) >= 50;
            cut += isObject && before[n] >= 0.5F ? 1 : 0;
            left += isObject && after[n] >= 0.5F ? 1 : 0;
        }
        EXPECT_GT(cut, 50) << name(tool);
        EXPECT_EQ(left, 0) << name(tool) << " of " << cut;
    }
}

TEST_F(ToolsTest, RestoreNeverPassesTheUncutSurface) {
    Head document;
    document.apply(scissorsAt(200, 130, 20)); // the air before and behind the head too
    Drill back = penAt<Drill>(200, 130, 10);
    back.restores = true;
    back.depthMax = 4000;
    back.canvas->view.range = {50, 255};
    document.apply(back);
    // Through the hole the far wall of nothing is seen: nothing to restore from.
    const auto seen = document.surface().probe({200, 130}, {400, 300});
    EXPECT_FALSE(seen.has_value());

    Head drilled;
    Drill drill = penAt<Drill>(200, 130, 14);
    drilled.apply(drill);
    const glm::dvec3 floor = drilled.surface().probe({200, 130}, {400, 300})->world;
    drill.restores = true;
    drill.depthMax = 2;
    drilled.apply(drill);
    const glm::dvec3 raised = drilled.surface().probe({200, 130}, {400, 300})->world;
    EXPECT_NEAR(glm::distance(floor, raised), 2, 0.3) << "steps of 1 mm";
    drill.depthMax = 1000;
    drilled.apply(drill);
    const glm::dvec3 whole = drilled.surface().probe({200, 130}, {400, 300})->world;
    Head untouched;
    EXPECT_LT(glm::distance(whole, untouched.surface().probe({200, 130}, {400, 300})->world), 0.05);
}

TEST_F(ToolsTest, KeepingOnDiggingGoesDeeper) {
    const auto depthOf = [](bool keepsDigging) {
        Head document;
        Drill drill = penAt<Drill>(200, 130, 12, {{{200, 130}, 0.5}, {{200, 130}, 0.6}, {{200, 130}, 0.5}});
        drill.keepsDigging = keepsDigging;
        drill.depthMax = 4;
        document.apply(drill);
        const auto place = document.surface().probe({200, 130}, {400, 300});
        Head whole;
        return glm::distance(place->world, whole.surface().probe({200, 130}, {400, 300})->world);
    };
    EXPECT_NEAR(depthOf(false), 2.4, 0.3);
    EXPECT_GT(depthOf(true), 5.5);
}

TEST_F(ToolsTest, PressureThatRisesFromZeroLooksAtTheSurfaceAgain) {
    Head once;
    once.apply(penAt<Drill>(200, 130, 12, {{{200, 130}, 0.15}, {{200, 130}, 0.15}}));
    Head twice;
    twice.apply(penAt<Drill>(200, 130, 12, {{{200, 130}, 0.15}, {{200, 130}, 0}, {{200, 130}, 0.15}}));
    const glm::dvec3 a = once.surface().probe({200, 130}, {400, 300})->world;
    const glm::dvec3 b = twice.surface().probe({200, 130}, {400, 300})->world;
    EXPECT_NEAR(glm::distance(a, b), 1.35, 0.3);
}

TEST_F(ToolsTest, TheDrillFollowsThePensTiltWhenAsked) {
    const auto cut = [](bool follows) {
        Head document;
        Drill drill = penAt<Drill>(200, 130, 8, {{{200, 130}, 1, {40, 0}}});
        drill.followsTilt = follows;
        document.apply(drill);
        return test::sculptureBytes(document);
    };
    Head upright;
    upright.apply(penAt<Drill>(200, 130, 8));
    EXPECT_TRUE(cut(false) == test::sculptureBytes(upright));
    EXPECT_FALSE(cut(true) == test::sculptureBytes(upright));
}

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
    const auto kept = document.surface().probe(op.pixel, {400, 300});
    ASSERT_TRUE(kept && document.surface().probe(other, {400, 300}));
    EXPECT_GT(document.apply(op).voxelsTouched, 100U);
    EXPECT_FALSE(document.surface().probe(other, {400, 300}));
    const auto still = document.surface().probe(op.pixel, {400, 300});
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

// Each live tool ends as its operation does.
TEST_F(ToolsTest, LiveStrokesEndAsTheirOperationsWould) {
    const sculpt::Stroke stroke{{{180, 130}, 0.4}, {{205, 134}, 1}, {{205, 134}, 0}, {{215, 140}, 0.7}};
    Drill drill = penAt<Drill>(180, 130, 9, stroke);
    Laser laser = penAt<Laser>(180, 130, 9, stroke);
    Drill digging = drill;
    digging.keepsDigging = true;
    for (const Operation& tool : std::vector<Operation>{drill, laser, digging}) {
        Head live;
        live.stroke().begin(tool);
        for (const auto& pen : stroke) {
            live.stroke().drawAt(pen);
            live.frame({100, 80}); // pictures are drawn meanwhile
        }
        live.stroke().commit();
        Head once;
        once.apply(tool);
        EXPECT_TRUE(test::sculptureBytes(live) == test::sculptureBytes(once)) << name(tool);
    }
}

// What a discarded stroke did is as if it had not been, for growth too.
TEST_F(ToolsTest, ADiscardedStrokeDoesNotChangeGrowth) {
    const auto grown = [](bool draws) {
        Head document;
        document.apply(test::brainSeed());
        document.apply(Grow{6, {}});
        Clip clip;
        clip.box = Clip::Box{{-1, -1, -1}, {80, 90, 33}};
        document.apply(clip);
        document.apply(Grow{5, {}});
        document.apply(Rewind{7});
        if (draws) {
            Peel peel = test::somePeel();
            peel.layers = 0;
            document.stroke().begin(peel);
            document.stroke().peelTo(3);
            document.stroke().discard();
        }
        document.apply(Grow{7, {}});
        return document.region().generations();
    };
    EXPECT_TRUE(grown(true) == grown(false));
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

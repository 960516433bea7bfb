// SPDX-License-Identifier: Apache-2.0
// What every tool promises, whatever it cuts (doc/behaviour.md, "Tools").
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_tools.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_stroke.h"
#include "studio/state/region.h"

namespace vs::studio {
namespace {

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
    for (const Operation& tool :
         std::vector<Operation>{penAt<Drill>(200, 130, 10), penAt<Laser>(200, 130, 10)}) {
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

} // namespace
} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/test_head.h"

#include <algorithm>
#include <random>

namespace vs::studio {
namespace {

using DocumentTest = test::GlTest;
using test::ellipseAt;
using test::testCanvas;
using test::testHead;

Peel somePeel(double layers = 8) {
    Peel op;
    op.mask = ellipseAt(200, 110, 40, 30);
    op.layers = layers;
    op.canvas = testCanvas();
    return op;
}

Seed brainSeed() {
    Seed op;
    op.voxels = {{35, 20, 29}};
    op.range = Range{80, 120};
    op.canvas = testCanvas();
    return op;
}

TEST_F(DocumentTest, APeelOpensTheSkullAndUndoPutsBackEveryByte) {
    Document document(testHead());
    const auto untouched = document.sculptureBytes();
    const Outcome peel = document.apply(somePeel());
    EXPECT_EQ(peel.name, "peel");
    EXPECT_GT(peel.voxelsTouched, 500U);
    const auto peeled = document.sculptureBytes();
    EXPECT_NE(peeled, untouched);

    Drill drill;
    drill.mask = ellipseAt(200, 180, 12, 12);
    drill.canvas = testCanvas();
    drill.stroke = {{{200, 180}, 0.5}, {{230, 185}, 1}};
    EXPECT_GT(document.apply(drill).voxelsTouched, 100U);
    const auto drilled = document.sculptureBytes();

    document.apply(Undo{});
    EXPECT_EQ(document.sculptureBytes(), peeled);
    document.apply(Undo{});
    EXPECT_EQ(document.sculptureBytes(), untouched);
    document.apply(Redo{});
    document.apply(Redo{});
    EXPECT_EQ(document.sculptureBytes(), drilled);
    document.apply(UnCut{});
    EXPECT_EQ(document.sculptureBytes(), untouched);
    document.apply(Undo{});
    EXPECT_EQ(document.sculptureBytes(), drilled);
}

TEST_F(DocumentTest, TheSurfaceUnderAPeelLiesAsManyStepsDeeper) {
    Document document(testHead());
    document.look(testCanvas().view);
    const auto before = document.probe({200, 110}, {400, 300});
    document.apply(somePeel(3));
    const auto after = document.probe({200, 110}, {400, 300});
    ASSERT_TRUE(before && after);
    // The skull is a shell around the grid's centre: a peel of 3 steps (3 mm) lowers its radius by 3.
    const auto centre = document.volume().geometry.centreWorld();
    EXPECT_NEAR(glm::length(before->world - centre) - glm::length(after->world - centre), 3, 0.3);
}

TEST_F(DocumentTest, ALiveStrokeEndsAsTheSameOperationWould) {
    Document live(testHead());
    live.beginPeel(somePeel().mask, testCanvas());
    for (const double layers : {1.0, 4.5, 9.0, 8.0}) {
        live.updatePeel(layers);
    }
    live.commitStroke();
    live.beginDrill(ellipseAt(200, 180, 12, 12), testCanvas(), 10);
    live.updateDrill({{200, 180}, 0.5});
    live.updateDrill({{230, 185}, 1});
    live.commitStroke();

    Document replayed(testHead());
    for (const Operation& operation : live.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(live.log().size(), 2U);
    EXPECT_EQ(replayed.sculptureBytes(), live.sculptureBytes());
}

TEST_F(DocumentTest, ADiscardedOrFruitlessStrokeLeavesNoTrace) {
    Document document(testHead());
    const auto untouched = document.sculptureBytes();
    document.beginPeel(somePeel().mask, testCanvas());
    document.updatePeel(6);
    EXPECT_NE(document.sculptureBytes(), untouched);
    document.discardStroke();
    EXPECT_EQ(document.sculptureBytes(), untouched);
    document.beginPeel(ellipseAt(5, 5, 4, 4), testCanvas()); // beside the head
    document.updatePeel(6);
    EXPECT_EQ(document.commitStroke().voxelsTouched, 0U);
    document.beginDrill(ellipseAt(200, 150, 9, 9), testCanvas(), 10);
    document.updateDrill({{200, 150}, 0}); // the pen hovers
    EXPECT_EQ(document.commitStroke().voxelsTouched, 0U);
    EXPECT_TRUE(document.log().empty());
    EXPECT_FALSE(document.canUndo());
}

TEST_F(DocumentTest, HoldingThePenStillChangesNothingAfterTheFirstStamp) {
    Document document(testHead());
    document.beginDrill(ellipseAt(200, 150, 9, 9), testCanvas(), 10);
    document.updateDrill({{200, 150}, 0.8});
    const auto once = document.sculptureBytes();
    for (int i = 0; i < 5; ++i) {
        document.updateDrill({{200, 150}, 0.8});
    }
    EXPECT_EQ(document.sculptureBytes(), once);
    document.commitStroke();
}

TEST_F(DocumentTest, GrowthFillsTheBrainAndStepsBothWaysExactly) {
    Document document(testHead());
    document.apply(brainSeed());
    document.apply(Grow{10});
    const auto ten = document.generations();
    document.apply(Grow{});
    const auto all = document.generations();
    const auto isBrain = [&](std::size_t i) { return std::uint8_t(document.volume().bytes[i]) == 100; };
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_EQ(all[i] > 0, isBrain(i)) << i;
    }
    const int last = document.growth().generation;
    document.apply(Rewind{last - 11});
    EXPECT_EQ(document.generations(), ten);
    document.apply(Grow{last - 11});
    EXPECT_EQ(document.generations(), all);
    document.apply(Undo{});
    EXPECT_EQ(document.generations(), ten);
    document.apply(Undo{});
    EXPECT_EQ(document.generations(), all);
}

TEST_F(DocumentTest, GrowthNeverEntersWhatWasCutAway) {
    Document document(testHead());
    document.apply(somePeel(14));
    document.apply(brainSeed());
    document.apply(Grow{});
    const auto labels = document.labels();
    const auto bytes = document.sculptureBytes();
    const auto* halves = reinterpret_cast<const std::uint16_t*>(bytes.data());
    std::size_t fenced = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const bool isCut = halves[i] >= 0x3800; // 0.5 as a half float
        EXPECT_FALSE(isCut && labels[i] == 1);
        fenced += isCut && std::uint8_t(document.volume().bytes[i]) == 100 ? 1 : 0;
    }
    EXPECT_GT(fenced, 50U) << "the peel must reach into the brain for this test to mean anything";
}

TEST_F(DocumentTest, LiveGrowthEndsAsOneOperation) {
    Document document(testHead());
    document.apply(brainSeed());
    const auto seeds = document.generations();
    document.beginGrowth();
    while (document.growFor(0.1, 3)) {
    }
    const Outcome outcome = document.endGrowth();
    const auto all = document.generations();
    EXPECT_EQ(outcome.voxelsTouched + 1, document.growth().voxels);
    EXPECT_EQ(document.log().size(), 2U);
    document.apply(Undo{});
    EXPECT_EQ(document.generations(), seeds);
    document.apply(Undo{});
    EXPECT_EQ(document.growth().voxels, 0U);
    document.apply(Redo{});
    document.apply(Redo{});
    EXPECT_EQ(document.generations(), all);
}

TEST_F(DocumentTest, StrokesFindSeedsOnTheVisibleSurface) {
    Document document(testHead());
    Seed op;
    op.strokes = {{Shape::FreeForm, {{180, 140}, {220, 150}}}};
    op.canvas = testCanvas();
    const Outcome outcome = document.apply(op);
    EXPECT_GT(outcome.voxelsTouched, 3U);
    const auto& logged = std::get<Seed>(document.log().back());
    EXPECT_EQ(logged.voxels.size(), outcome.voxelsTouched);
    for (const glm::ivec3 v : logged.voxels) {
        EXPECT_EQ(document.volume().at(v), 200) << "on the skull";
    }
    EXPECT_EQ(document.growth().range, (Range{50, 255})) << "the run takes the displayed range";
}

TEST_F(DocumentTest, UndoAndRedoAtRandomReturnToTheSameStates) {
    Document document(testHead());
    std::mt19937 random(3);
    std::vector<std::pair<std::vector<std::byte>, std::vector<std::uint32_t>>> states;
    const auto state = [&] { return std::pair(document.sculptureBytes(), document.generations()); };
    states.push_back(state());
    for (int i = 0; i < 8; ++i) {
        const double x = 150 + double(random() % 100);
        const double y = 90 + double(random() % 120);
        switch (i % 4) {
        case 0: {
            Peel peel = somePeel(double(random() % 9) + 1);
            peel.mask = ellipseAt(x, y, 25, 20);
            document.apply(peel);
            break;
        }
        case 1:
            document.apply(brainSeed());
            break;
        case 2:
            document.apply(Grow{5});
            break;
        default: {
            Drill drill;
            drill.mask = ellipseAt(x, y, 10, 10);
            drill.canvas = testCanvas();
            document.apply(drill);
        }
        }
        states.push_back(state());
    }
    std::size_t at = states.size() - 1;
    for (int i = 0; i < 40; ++i) {
        const bool back = random() % 2 == 0;
        if (back ? document.canUndo() : document.canRedo()) {
            document.apply(back ? Operation(Undo{}) : Operation(Redo{}));
            at += back ? std::size_t(-1) : 1;
        }
        ASSERT_TRUE(state() == states[at]) << "after " << i << " moves, at state " << at;
    }
}

// A document whose view is the probe's, with a seed in the brain: everything that a fence can go wrong with.
View probeView() {
    View view = testCanvas().view;
    view.sculptureView = field::SculptureView::Probe;
    return view;
}

Drill drillInProbeView() {
    Drill drill;
    drill.mask = ellipseAt(200, 150, 15, 15);
    drill.canvas = testCanvas();
    drill.canvas->view = probeView();
    return drill;
}

TEST_F(DocumentTest, UndoingTheFirstCutIsAsIfNothingHadBeenCut) {
    Document document(testHead());
    document.look(probeView());
    const auto picture = [&] {
        render::RayCaster caster;
        caster.render(document.frame({160, 120}));
        return caster.readPicture().rgba;
    };
    const auto whole = picture(); // nothing cut yet: the probe view shows everything
    document.apply(drillInProbeView());
    const auto plug = picture();
    EXPECT_NE(plug, whole);
    document.apply(Undo{});
    EXPECT_EQ(picture(), whole);
    document.apply(Redo{});
    EXPECT_EQ(picture(), plug);
    document.apply(Undo{});
    document.apply(UnCut{});
    document.apply(Undo{});
    EXPECT_EQ(picture(), whole);
    document.beginPeel(somePeel().mask, testCanvas());
    document.updatePeel(5);
    document.discardStroke();
    EXPECT_EQ(picture(), whole);
}

TEST_F(DocumentTest, RedoWorksAfterTheFirstCutOfAProbeView) {
    Document document(testHead());
    document.look(probeView());
    Seed seed = brainSeed();
    seed.canvas->view = probeView();
    document.apply(seed);
    document.apply(Grow{3});
    const auto grown = document.generations();
    document.apply(drillInProbeView());
    for (int i = 0; i < 3; ++i) {
        document.apply(Undo{});
    }
    document.apply(Redo{});
    document.apply(Redo{});
    EXPECT_EQ(document.generations(), grown);
    document.apply(Undo{});
    document.apply(Undo{});
    EXPECT_FALSE(document.canUndo());
}

TEST_F(DocumentTest, PicturesDrawnDuringAStrokeDoNotChangeIt) {
    const auto drilled = [](bool drawsFrames) {
        Document document(testHead());
        document.look(probeView());
        document.beginDrill(drillInProbeView().mask, *drillInProbeView().canvas, 10);
        for (const double x : {150.0, 180.0, 210.0, 240.0}) {
            document.updateDrill({{x, 150}, 1});
            if (drawsFrames) {
                render::RayCaster().render(document.frame({80, 60}));
            }
        }
        document.commitStroke();
        return document.sculptureBytes();
    };
    EXPECT_EQ(drilled(true), drilled(false));
}

TEST_F(DocumentTest, GrowthIsFencedByTheViewThatItBeganIn) {
    Document document(testHead());
    document.look(testCanvas().view);
    document.apply(somePeel(14));
    document.apply(brainSeed());
    document.beginGrowth();
    document.growFor(0, 2);
    View whole = testCanvas().view;
    whole.sculptureView = field::SculptureView::Whole;
    document.look(whole); // while it plays
    while (document.growFor(1, 1000)) {
    }
    document.endGrowth();
    const auto fenced = document.generations();
    document.apply(Undo{});
    document.apply(Redo{});
    EXPECT_EQ(document.generations(), fenced);

    Document replayed(testHead());
    for (const Operation& operation : document.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(replayed.generations(), fenced);
    EXPECT_EQ(replayed.view(), document.view());
}

TEST_F(DocumentTest, RedoOfGrowthKeepsItsFenceWhateverTheViewIsNow) {
    Document document(testHead());
    document.look(testCanvas().view);
    document.apply(somePeel(14));
    document.apply(brainSeed());
    document.apply(Grow{12});
    const auto fenced = document.generations();
    document.apply(Rewind{1});
    document.apply(Grow{1});
    EXPECT_EQ(document.generations(), fenced);
    View whole = testCanvas().view;
    whole.sculptureView = field::SculptureView::Whole;
    document.look(whole);
    for (const int steps : {1, 3}) { // the last growth; the last growth, the rewind and the first
        for (int i = 0; i < steps; ++i) {
            document.apply(Undo{});
        }
        for (int i = 0; i < steps; ++i) {
            document.apply(Redo{});
        }
        EXPECT_EQ(document.generations(), fenced);
    }
}

TEST_F(DocumentTest, RewindingOnAndOnIsOneStep) {
    Document document(testHead());
    document.apply(brainSeed());
    document.apply(Grow{12});
    const auto grown = document.generations();
    for (const int generations : {1, 1, 3}) {
        document.rewindFurther(generations);
    }
    EXPECT_EQ(document.growth().generation, 8);
    EXPECT_EQ(document.log().size(), 3U);
    const auto rewound = document.generations();
    document.apply(Undo{});
    EXPECT_EQ(document.generations(), grown);
    document.apply(Redo{});
    EXPECT_EQ(document.generations(), rewound);
    Document replayed(testHead());
    for (const Operation& operation : document.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(replayed.generations(), rewound);
}

TEST_F(DocumentTest, AFewSeedsCanBeSeen) {
    Document document(testHead());
    View view = testCanvas({60, 255}).view;
    view.mode = render::Mode::Segment;
    document.look(view);
    const auto picture = [&] {
        render::RayCaster caster;
        caster.render(document.frame({400, 300}));
        return caster.readPicture();
    };
    const auto before = picture();
    Seed op;
    op.strokes = {{Shape::FreeForm, {{180, 140}, {220, 150}}}};
    op.canvas = Canvas{view, {400, 300}};
    document.apply(op);
    const auto after = picture();
    int tinted = 0;
    for (std::size_t i = 0; i < after.rgba.size(); i += 4) { // the segment's colour has little blue
        tinted += after.rgba[i + 2] + 20 < before.rgba[i + 2] ? 1 : 0;
    }
    EXPECT_GT(tinted, 60) << "a stroke of 40 pixels must show";
}

TEST_F(DocumentTest, WhatWasLookedAtIsInTheLog) {
    Document document(testHead());
    View view = document.view();
    view.camera.azimuthDegrees = 70;
    document.look(view);
    document.apply(SetView{{}, render::Mode::XRay, {}, {}});
    Document replayed(testHead());
    for (const Operation& operation : document.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(replayed.view(), document.view());
    EXPECT_EQ(replayed.view().camera.azimuthDegrees, 70);
}

TEST_F(DocumentTest, AStrokeFarBesideThePictureCostsNothing) {
    Document document(testHead());
    Drill drill;
    drill.mask = ellipseAt(200, 150, 9, 9);
    drill.canvas = testCanvas();
    drill.stroke = {{{0, 150}, 1}, {{900000, 150}, 1}};
    const Outcome outcome = document.apply(drill);
    EXPECT_GT(outcome.voxelsTouched, 100U); // the part that crosses the head
    EXPECT_LT(outcome.milliseconds, 20000);
}

TEST_F(DocumentTest, SeedsOutsideTheGridAreReported) {
    Document document(testHead());
    Seed seed = brainSeed();
    seed.voxels.emplace_back(500, 1, 1);
    EXPECT_NE(document.apply(seed).message.find("1 refused"), std::string::npos);
}

TEST_F(DocumentTest, WhatMakesNoSenseIsRefusedAndChangesNothing) {
    Document document(testHead());
    EXPECT_THROW(document.apply(Undo{}), Error);
    EXPECT_THROW(document.apply(Redo{}), Error);
    EXPECT_THROW(document.apply(Grow{}), Error);
    EXPECT_THROW(document.apply(Rewind{}), Error);
    EXPECT_TRUE(document.log().empty());
}

} // namespace
} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/test_head.h"
#include "property.h"

#include <algorithm>

namespace vs::studio {
namespace {

using DocumentTest = test::GlTest;
using test::brainSeed;
using test::drillInProbeView;
using test::ellipseAt;
using test::probeView;
using test::somePeel;
using test::testCanvas;
using test::testHead;

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

TEST_F(DocumentTest, WhatUndoWouldTakeBackIsTold) {
    Document document(testHead());
    EXPECT_EQ(document.lastStep(), nullptr);
    document.apply(somePeel());
    EXPECT_STREQ(name(*document.lastStep()), "peel");
    document.apply(Paste{});
    EXPECT_STREQ(name(*document.lastStep()), "paste");
    document.apply(Undo{});
    EXPECT_STREQ(name(*document.lastStep()), "peel");
    document.apply(Undo{});
    EXPECT_EQ(document.lastStep(), nullptr);
}

TEST_F(DocumentTest, TheBoxOfAPastedPartLiesAroundWhatWasCutSinceTheLastPaste) {
    Document document(testHead());
    document.look(testCanvas().view);
    EXPECT_TRUE(document.partBox(0).isEmpty());
    const auto drillAt = [&](glm::dvec2 place) {
        Drill drill;
        drill.mask = ellipseAt(place.x, place.y, 12, 12);
        drill.canvas = testCanvas();
        const glm::dvec3 surface = document.probe(place, testCanvas().viewport).value().voxel;
        EXPECT_GT(document.apply(drill).voxelsTouched, 100U);
        return surface;
    };
    const auto isIn = [](const Box3& box, glm::dvec3 voxel) {
        return glm::all(glm::lessThanEqual(glm::dvec3(box.lo), voxel)) &&
               glm::all(glm::lessThan(voxel, glm::dvec3(box.hi)));
    };
    const glm::dvec3 first = drillAt({170, 150});
    const Box3 next = document.partBox(0);
    EXPECT_TRUE(isIn(next, first));
    document.apply(Paste{});
    EXPECT_EQ(document.partBox(0), next);
    EXPECT_TRUE(document.partBox(1).isEmpty()) << "nothing was cut since";
    const glm::dvec3 second = drillAt({235, 150});
    EXPECT_TRUE(isIn(document.partBox(1), second));
    document.apply(Paste{});
    EXPECT_TRUE(isIn(document.partBox(0), first));
    EXPECT_FALSE(isIn(document.partBox(0), second));
    EXPECT_TRUE(isIn(document.partBox(1), second));
    EXPECT_FALSE(isIn(document.partBox(1), first));
}

TEST_F(DocumentTest, SamplingIsPartOfTheView) {
    Document document(testHead());
    SetView cubic;
    cubic.sampling = field::Sampling::Tricubic;
    const auto surface = [&] { return document.probe({200, 150}, {400, 300}).value().voxel; };
    const glm::dvec3 linearly = surface();
    document.apply(cubic);
    EXPECT_EQ(document.view().sampling, field::Sampling::Tricubic);
    EXPECT_EQ(document.frame({40, 30}).scene.sampling, field::Sampling::Tricubic);
    const double moved = glm::length(surface() - linearly);
    EXPECT_GT(moved, 1e-3) << "another surface is picked";
    EXPECT_LT(moved, 0.5);
    document.apply(SetView{});
    EXPECT_EQ(document.view().sampling, field::Sampling::Tricubic) << "what is not given stays";
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
    live.beginStroke(Peel{somePeel().mask, 0, 3, false, testCanvas()});
    for (const double layers : {1.0, 4.5, 9.0, 8.0}) {
        live.updatePeel(layers);
    }
    live.commitStroke();
    live.beginStroke(test::drillOf(ellipseAt(200, 180, 12, 12), testCanvas()));
    live.updatePen({{200, 180}, 0.5});
    live.updatePen({{230, 185}, 1});
    live.commitStroke();

    Document replayed(testHead());
    for (const Operation& operation : live.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(live.log().size(), 2U);
    EXPECT_EQ(replayed.sculptureBytes(), live.sculptureBytes());
}

TEST_F(DocumentTest, ThePrecisionOfCutsCanBeChosen) {
    const std::size_t voxels = testHead().geometry.voxelCount();
    std::size_t changed = 0;
    for (const auto& [precision, bytes] : {std::pair(sculpt::Precision::Bits8, 1U),
                                           {sculpt::Precision::Bits16, 2U},
                                           {sculpt::Precision::Bits32, 4U}}) {
        Document document(testHead(), precision);
        const auto untouched = document.sculptureBytes();
        EXPECT_EQ(untouched.size(), voxels * bytes);
        const std::size_t touched = document.apply(somePeel()).voxelsTouched;
        EXPECT_GE(touched, changed) << "finer steps, more of the edge";
        EXPECT_GT(touched, 500U);
        changed = touched;
        document.apply(Undo{});
        EXPECT_EQ(document.sculptureBytes(), untouched);
    }
}

TEST_F(DocumentTest, ADiscardedOrFruitlessStrokeLeavesNoTrace) {
    Document document(testHead());
    const auto untouched = document.sculptureBytes();
    document.beginStroke(Peel{somePeel().mask, 0, 3, false, testCanvas()});
    document.updatePeel(6);
    EXPECT_NE(document.sculptureBytes(), untouched);
    document.discardStroke();
    EXPECT_EQ(document.sculptureBytes(), untouched);
    document.beginStroke(Peel{ellipseAt(5, 5, 4, 4), 0, 3, false, testCanvas()}); // beside the head
    document.updatePeel(6);
    EXPECT_EQ(document.commitStroke().voxelsTouched, 0U);
    document.beginStroke(test::drillOf(ellipseAt(200, 150, 9, 9), testCanvas()));
    document.updatePen({{200, 150}, 0}); // the pen hovers
    EXPECT_EQ(document.commitStroke().voxelsTouched, 0U);
    EXPECT_TRUE(document.log().empty());
    EXPECT_FALSE(document.canUndo());
}

TEST_F(DocumentTest, HoldingThePenStillChangesNothingAfterTheFirstStamp) {
    Document document(testHead());
    document.beginStroke(test::drillOf(ellipseAt(200, 150, 9, 9), testCanvas()));
    document.updatePen({{200, 150}, 0.8});
    const auto once = document.sculptureBytes();
    for (int i = 0; i < 5; ++i) {
        document.updatePen({{200, 150}, 0.8});
    }
    EXPECT_EQ(document.sculptureBytes(), once);
    document.commitStroke();
}

TEST_F(DocumentTest, UndoAndRedoAtRandomReturnToTheSameStates) {
    test::checkProperty(2, [] {
        Document document(testHead());
        std::vector<std::pair<std::vector<std::byte>, std::vector<std::uint32_t>>> states;
        const auto state = [&] { return std::pair(document.sculptureBytes(), document.generations()); };
        states.push_back(state());
        for (int i = 0; i < 8; ++i) {
            const double x = 150 + *test::below(100);
            const double y = 90 + *test::below(120);
            switch (i % 4) {
            case 0: {
                Peel peel = somePeel(*test::below(9) + 1);
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
        for (const bool isBack : *test::upTo(40, test::coin())) {
            if (isBack ? document.canUndo() : document.canRedo()) {
                document.apply(isBack ? Operation(Undo{}) : Operation(Redo{}));
                at += isBack ? std::size_t(-1) : 1;
            }
            RC_ASSERT((state() == states[at]));
        }
    });
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
    document.beginStroke(Peel{somePeel().mask, 0, 3, false, testCanvas()});
    document.updatePeel(5);
    document.discardStroke();
    EXPECT_EQ(picture(), whole);
}

TEST_F(DocumentTest, PicturesDrawnDuringAStrokeDoNotChangeIt) {
    const auto drilled = [](bool drawsFrames) {
        Document document(testHead());
        document.look(probeView());
        document.beginStroke(drillInProbeView());
        for (const double x : {150.0, 180.0, 210.0, 240.0}) {
            document.updatePen({{x, 150}, 1});
            if (drawsFrames) {
                render::RayCaster().render(document.frame({80, 60}));
            }
        }
        document.commitStroke();
        return document.sculptureBytes();
    };
    EXPECT_EQ(drilled(true), drilled(false));
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
    EXPECT_LT(outcome.milliseconds, 30000) << "a guard against one stamp for each step of the way";
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

// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_head.h"
#include "property.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_stroke.h"
#include "studio/document/part_queries.h"
#include "studio/document/surface_queries.h"
#include "studio/state/region.h"

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
    const auto untouched = test::sculptureBytes(document);
    const Outcome peel = document.apply(somePeel());
    EXPECT_EQ(peel.name, "peel");
    EXPECT_GT(peel.voxelsTouched, 500U);
    const auto peeled = test::sculptureBytes(document);
    EXPECT_NE(peeled, untouched);

    Drill drill;
    drill.mask = ellipseAt(200, 180, 12, 12);
    drill.canvas = testCanvas();
    drill.stroke = {{{200, 180}, 0.5}, {{230, 185}, 1}};
    EXPECT_GT(document.apply(drill).voxelsTouched, 100U);
    const auto drilled = test::sculptureBytes(document);

    document.apply(Undo{});
    EXPECT_EQ(test::sculptureBytes(document), peeled);
    document.apply(Undo{});
    EXPECT_EQ(test::sculptureBytes(document), untouched);
    document.apply(Redo{});
    document.apply(Redo{});
    EXPECT_EQ(test::sculptureBytes(document), drilled);
    document.apply(UnCut{});
    EXPECT_EQ(test::sculptureBytes(document), untouched);
    document.apply(Undo{});
    EXPECT_EQ(test::sculptureBytes(document), drilled);
}

TEST_F(DocumentTest, WhatUndoWouldTakeBackIsTold) {
    Document document(testHead());
    EXPECT_EQ(document.facts()->lastEdit(), nullptr);
    document.apply(somePeel());
    EXPECT_STREQ(name(*document.facts()->lastEdit()), "peel");
    document.apply(Paste{});
    EXPECT_STREQ(name(*document.facts()->lastEdit()), "paste");
    document.apply(Undo{});
    EXPECT_STREQ(name(*document.facts()->lastEdit()), "peel");
    document.apply(Undo{});
    EXPECT_EQ(document.facts()->lastEdit(), nullptr);
}

TEST_F(DocumentTest, UndoAndRedoOfPastedPartsAreLoggedWithoutAViewThatNobodyChose) {
    Document document(testHead());
    MovePart further;
    further.place.moveMm = {60, 0, 0};
    for (const Operation& operation :
         std::vector<Operation>{somePeel(), Paste{}, Undo{}, Redo{}, further, Undo{}, UnCut{}, Undo{}}) {
        document.apply(operation);
    }
    EXPECT_EQ(document.log().size(), 8U);
}

TEST_F(DocumentTest, TheBoxOfAPastedPartLiesAroundWhatWasCutSinceTheLastPaste) {
    Document document(testHead());
    document.showView(testCanvas().view);
    EXPECT_TRUE(document.parts().nextBox().isEmpty());
    const auto drillAt = [&](glm::dvec2 place) {
        Drill drill;
        drill.mask = ellipseAt(place.x, place.y, 12, 12);
        drill.canvas = testCanvas();
        const glm::dvec3 surface = document.surface().probe(place, testCanvas().viewport).value().voxel;
        EXPECT_GT(document.apply(drill).voxelsTouched, 100U);
        return surface;
    };
    const auto isIn = [](const Box3& box, glm::dvec3 voxel) {
        return glm::all(glm::lessThanEqual(glm::dvec3(box.lo), voxel)) &&
               glm::all(glm::lessThan(voxel, glm::dvec3(box.hi)));
    };
    const glm::dvec3 first = drillAt({170, 150});
    const Box3 next = document.parts().nextBox();
    EXPECT_TRUE(isIn(next, first));
    document.apply(Paste{});
    EXPECT_EQ(document.parts().box(0), next);
    EXPECT_TRUE(document.parts().nextBox().isEmpty()) << "nothing was cut since";
    const glm::dvec3 second = drillAt({235, 150});
    EXPECT_TRUE(isIn(document.parts().nextBox(), second));
    document.apply(Paste{});
    EXPECT_TRUE(isIn(document.parts().box(0), first));
    EXPECT_FALSE(isIn(document.parts().box(0), second));
    EXPECT_TRUE(isIn(document.parts().box(1), second));
    EXPECT_FALSE(isIn(document.parts().box(1), first));
}

TEST_F(DocumentTest, SamplingIsPartOfTheView) {
    Document document(testHead());
    SetView cubic;
    cubic.sampling = field::Sampling::Tricubic;
    const auto surface = [&] { return document.surface().probe({200, 150}, {400, 300}).value().voxel; };
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
    document.showView(testCanvas().view);
    const auto before = document.surface().probe({200, 110}, {400, 300});
    document.apply(somePeel(3));
    const auto after = document.surface().probe({200, 110}, {400, 300});
    ASSERT_TRUE(before && after);
    // The skull is a shell around the grid's centre: a peel of 3 steps (3 mm) lowers its radius by 3.
    const auto centre = document.volume().geometry.centreWorld();
    EXPECT_NEAR(glm::length(before->world - centre) - glm::length(after->world - centre), 3, 0.3);
}

TEST_F(DocumentTest, ALiveStrokeEndsAsTheSameOperationWould) {
    Document live(testHead());
    live.stroke().begin(Peel{somePeel().mask, 0, 3, false, testCanvas()});
    for (const double layers : {1.0, 4.5, 9.0, 8.0}) {
        live.stroke().peelTo(layers);
    }
    live.stroke().commit();
    live.stroke().begin(test::drillOf(ellipseAt(200, 180, 12, 12), testCanvas()));
    live.stroke().drawAt({{200, 180}, 0.5});
    live.stroke().drawAt({{230, 185}, 1});
    live.stroke().commit();

    Document replayed(testHead());
    for (const Operation& operation : live.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(live.log().size(), 2U);
    EXPECT_EQ(test::sculptureBytes(replayed), test::sculptureBytes(live));
}

TEST_F(DocumentTest, ThePrecisionOfCutsCanBeChosen) {
    const std::size_t voxels = testHead().geometry.voxelCount();
    std::size_t changed = 0;
    for (const auto& [precision, bytes] : {std::pair(sculpt::Precision::Bits8, 1U),
                                           {sculpt::Precision::Bits16, 2U},
                                           {sculpt::Precision::Bits32, 4U}}) {
        Document document(testHead(), precision);
        const auto untouched = test::sculptureBytes(document);
        EXPECT_EQ(untouched.size(), voxels * bytes);
        const std::size_t touched = document.apply(somePeel()).voxelsTouched;
        EXPECT_GE(touched, changed) << "finer steps, more of the edge";
        EXPECT_GT(touched, 500U);
        changed = touched;
        document.apply(Undo{});
        EXPECT_EQ(test::sculptureBytes(document), untouched);
    }
}

TEST_F(DocumentTest, ADiscardedOrFruitlessStrokeLeavesNoTrace) {
    Document document(testHead());
    const auto untouched = test::sculptureBytes(document);
    document.stroke().begin(Peel{somePeel().mask, 0, 3, false, testCanvas()});
    document.stroke().peelTo(6);
    EXPECT_NE(test::sculptureBytes(document), untouched);
    document.stroke().discard();
    EXPECT_EQ(test::sculptureBytes(document), untouched);
    document.stroke().begin(Peel{ellipseAt(5, 5, 4, 4), 0, 3, false, testCanvas()}); // beside the head
    document.stroke().peelTo(6);
    EXPECT_EQ(document.stroke().commit().voxelsTouched, 0U);
    document.stroke().begin(test::drillOf(ellipseAt(200, 150, 9, 9), testCanvas()));
    document.stroke().drawAt({{200, 150}, 0}); // the pen hovers
    EXPECT_EQ(document.stroke().commit().voxelsTouched, 0U);
    EXPECT_TRUE(document.log().empty());
    EXPECT_FALSE(document.facts()->canUndo());
}

TEST_F(DocumentTest, HoldingThePenStillChangesNothingAfterTheFirstStamp) {
    Document document(testHead());
    document.stroke().begin(test::drillOf(ellipseAt(200, 150, 9, 9), testCanvas()));
    document.stroke().drawAt({{200, 150}, 0.8});
    const auto once = test::sculptureBytes(document);
    for (int i = 0; i < 5; ++i) {
        document.stroke().drawAt({{200, 150}, 0.8});
    }
    EXPECT_EQ(test::sculptureBytes(document), once);
    document.stroke().commit();
}

TEST_F(DocumentTest, UndoAndRedoAtRandomReturnToTheSameStates) {
    test::checkProperty(2, [] {
        Document document(testHead());
        std::vector<std::pair<std::vector<std::byte>, std::vector<std::uint32_t>>> states;
        const auto state = [&] {
            return std::pair(test::sculptureBytes(document), document.region().generations());
        };
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
            if (isBack ? document.facts()->canUndo() : document.facts()->canRedo()) {
                document.apply(isBack ? Operation(Undo{}) : Operation(Redo{}));
                at += isBack ? std::size_t(-1) : 1;
            }
            RC_ASSERT((state() == states[at]));
        }
    });
}

TEST_F(DocumentTest, UndoingTheFirstCutIsAsIfNothingHadBeenCut) {
    Document document(testHead());
    document.showView(probeView());
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
    document.stroke().begin(Peel{somePeel().mask, 0, 3, false, testCanvas()});
    document.stroke().peelTo(5);
    document.stroke().discard();
    EXPECT_EQ(picture(), whole);
}

TEST_F(DocumentTest, PicturesDrawnDuringAStrokeDoNotChangeIt) {
    const auto drilled = [](bool drawsFrames) {
        Document document(testHead());
        document.showView(probeView());
        document.stroke().begin(drillInProbeView());
        for (const double x : {150.0, 180.0, 210.0, 240.0}) {
            document.stroke().drawAt({{x, 150}, 1});
            if (drawsFrames) {
                render::RayCaster().render(document.frame({80, 60}));
            }
        }
        document.stroke().commit();
        return test::sculptureBytes(document);
    };
    EXPECT_EQ(drilled(true), drilled(false));
}

TEST_F(DocumentTest, WhatWasLookedAtIsInTheLog) {
    Document document(testHead());
    View view = document.view();
    view.camera.azimuthDegrees = 70;
    document.showView(view);
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

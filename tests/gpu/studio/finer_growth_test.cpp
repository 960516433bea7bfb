// SPDX-License-Identifier: Apache-2.0
// Segments of a scan that is worked on at a coarser level than its finest grow at that one.
#include "gpu/studio/head_in_bricks.h"
#include "image/compare.h"
#include "studio/document/live_growth.h"

#include <algorithm>
#include <utility>

namespace vs::studio {
namespace {

using FinerGrowthTest = test::GlTest;

Seed seedAt(double x, double y) {
    Seed seed;
    seed.strokes = {Sketch{Shape::Polyline, {{x, y}, {x + 12, y + 4}}}};
    seed.range = Range{20, 255};
    seed.canvas = testCanvas();
    return seed;
}

Absorb absorbAt(double x, double y) {
    Absorb absorb;
    absorb.strokes = {Sketch{Shape::Polyline, {{x, y}, {x + 5, y}}}};
    absorb.expansions = 4;
    absorb.canvas = testCanvas();
    return absorb;
}

UseSegment useSegment(const char* name) {
    UseSegment use;
    use.segment = name;
    return use;
}

EditSegment edit(EditSegment::Kind kind, double amount) {
    EditSegment edit;
    edit.kind = kind;
    edit.amount = amount;
    return edit;
}

PaintSegment paintAround(glm::dvec3 voxel) {
    PaintSegment paint;
    paint.trail.points = {voxel};
    paint.trail.radiusMm = 6;
    return paint;
}

std::vector<Operation> history() {
    SetGrowthRules rules;
    rules.range = Range{40, 200};
    rules.isLive = true;
    return {seedAt(200, 130),
            Grow{12},
            rules,
            Grow{10},
            absorbAt(203, 131),
            Rewind{3},
            edit(EditSegment::Kind::Margin, 4),
            edit(EditSegment::Kind::Margin, -3),
            useSegment("Other"),
            seedAt(150, 170),
            Grow{},
            ShowGeneration{5},
            paintAround({20, 20, 20}),
            ReSeed{}};
}

std::size_t countOf(const std::vector<std::uint8_t>& labels, std::uint8_t label) {
    return std::size_t(std::count(labels.begin(), labels.end(), label));
}

TEST_F(FinerGrowthTest, EachStepIsUndoneAndRedoneToTheByte) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    std::vector<std::vector<std::uint8_t>> labels;
    std::vector<std::vector<std::uint8_t>> scene;
    for (const Operation& operation : history()) {
        labels.push_back(inBricks.labels());
        scene.push_back(document.region().labelMap());
        document.apply(operation);
        const auto& region = document.region();
        EXPECT_EQ(region.voxelCount(1), countOf(inBricks.labels(), 1)) << name(operation);
        EXPECT_EQ(region.voxelCount(2), countOf(inBricks.labels(), 2)) << name(operation);
    }
    const auto after = inBricks.labels();
    for (std::size_t n = labels.size(); n-- > 0;) {
        document.apply(Undo{});
        EXPECT_TRUE(n == 0 ? countOf(inBricks.labels(), 0) == inBricks.labels().size()
                           : inBricks.labels() == labels[n])
            << n;
        EXPECT_EQ(document.region().labelMap(), scene[n]) << n;
    }
    for (std::size_t n = 1; n < labels.size(); ++n) {
        document.apply(Redo{});
        EXPECT_EQ(inBricks.labels(), labels[n]) << n;
        EXPECT_EQ(document.region().labelMap(), scene[n]) << n;
    }
    document.apply(Redo{});
    EXPECT_EQ(inBricks.labels(), after);
}

TEST_F(FinerGrowthTest, GrowthThatIsShownIsItsOperation) {
    InBricks shown;
    InBricks atOnce;
    for (InBricks* one : {&shown, &atOnce}) {
        one->document->apply(seedAt(200, 130));
    }
    LiveGrowth& live = shown.document->growing();
    live.begin();
    int portions = 0;
    while (live.growFor(0.1, 3)) {
        ++portions;
    }
    live.end();
    EXPECT_GT(portions, 5);
    atOnce.document->apply(Grow{});
    EXPECT_EQ(shown.labels(), atOnce.labels());
    EXPECT_GT(countOf(shown.labels(), 1), 5000U);
    shown.document->apply(Undo{});
    atOnce.document->apply(Undo{});
    EXPECT_EQ(shown.labels(), atOnce.labels());
    EXPECT_GT(countOf(shown.labels(), 1), 0U);
}

TEST_F(FinerGrowthTest, ScrubbingShowsWhatThereWasThen) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    document.apply(seedAt(200, 130));
    document.apply(Grow{6});
    const auto then = inBricks.labels();
    const auto sceneThen = document.region().labelMap();
    document.apply(Grow{20});
    const auto now = inBricks.labels();
    ASSERT_NE(now, then);
    document.growing().scrub(int(document.facts()->growth.generation) - 20);
    EXPECT_EQ(inBricks.labels(), then);
    document.growing().dropScrub();
    EXPECT_EQ(inBricks.labels(), now);
    EXPECT_EQ(countOf(sceneThen, 0) + countOf(sceneThen, 1), sceneThen.size());
}

TEST_F(FinerGrowthTest, WhereValuesCannotBeReadNothingIsDone) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    inBricks.source->unreadable = glm::ivec3(64, 0, 0);
    document.apply(seedAt(200, 130));
    document.apply(Grow{2});
    const auto before = inBricks.labels();
    const auto logged = document.log().size();
    try {
        document.apply(Grow{});
        ADD_FAILURE() << "it grew where nothing can be read";
    } catch (const ReadError& error) {
        EXPECT_NE(std::string(error.what()).find("damaged"), std::string::npos);
    }
    EXPECT_EQ(inBricks.labels(), before);
    EXPECT_EQ(document.log().size(), logged);
    inBricks.source->unreadable.reset();
    document.apply(Grow{});
    EXPECT_GT(countOf(inBricks.labels(), 1), countOf(before, 1));
}

TEST_F(FinerGrowthTest, WhatIsCutFencesIt) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    document.apply(scissorsAt(200, 130, 25));
    document.apply(seedAt(150, 170));
    document.apply(Grow{});
    const auto labels = inBricks.labels();
    const auto cuts = inBricks.cuts();
    std::size_t inside = 0;
    for (std::size_t n = 0; n < labels.size(); ++n) {
        inside += labels[n] != 0 && cuts[n] >= 0.5F ? 1 : 0;
    }
    EXPECT_EQ(inside, 0U);
    EXPECT_GT(countOf(labels, 1), 5000U);
}

TEST_F(FinerGrowthTest, EditsAreThoseOfAllOfTheFinestLevel) {
    InBricks inBricks;
    Head whole;
    PaintSegment paint = paintAround({20.3, 20, 20.6});
    inBricks.document->apply(paint);
    const field::BrickGrid& grid = inBricks.document->region().finestGrid();
    paint.trail.points.front() = paint.trail.points.front() * grid.perSceneVoxel + grid.origin;
    whole.apply(paint);
    ASSERT_GT(countOf(inBricks.labels(), 1), 500U);
    ASSERT_EQ(whole.region().labelMap(), inBricks.labels());
    using Kind = EditSegment::Kind;
    for (const EditSegment& op :
         {edit(Kind::Margin, 4), edit(Kind::Smooth, 2), edit(Kind::Hollow, 3), edit(Kind::FillHoles, 0),
          edit(Kind::Open, 1.5), edit(Kind::KeepLargest, 0)}) {
        const auto before = inBricks.labels();
        whole.apply(op);
        inBricks.document->apply(op);
        const auto after = inBricks.labels();
        ASSERT_EQ(whole.region().labelMap(), after) << nameOf(op.kind);
        inBricks.document->apply(Undo{});
        EXPECT_EQ(inBricks.labels(), before) << nameOf(op.kind);
        inBricks.document->apply(Redo{});
        EXPECT_EQ(inBricks.labels(), after) << nameOf(op.kind);
    }
}

// A voxel of a level that is not there names no island: it is looked for under the pixel again.
TEST_F(FinerGrowthTest, IslandsOfTheSceneAreNotNamedByFinestVoxels) {
    Head whole;
    whole.apply(seedAt(200, 130));
    whole.apply(Grow{3});
    const auto grown = countOf(whole.region().labelMap(), 1);
    EditSegment keep = edit(EditSegment::Kind::KeepIsland, 0);
    keep.pixel = glm::dvec2(206, 132);
    keep.finest = glm::ivec3(0);
    keep.canvas = testCanvas();
    whole.apply(keep);
    EXPECT_GT(countOf(whole.region().labelMap(), 1), grown / 2);
}

// Pictures at rest show segments as pictures of the finest level would, whole and cut, with room for a few
// bricks or many.
TEST_F(FinerGrowthTest, SegmentsAreSeenAsTheyAre) {
    InBricks roomy;
    InBricks tight(16, 40);
    Head whole;
    roomy.document->apply(seedAt(200, 130));
    Seed seed = std::get<Seed>(roomy.document->log().back());
    tight.document->apply(seed);
    seed.voxels = std::exchange(seed.finest, {});
    whole.apply(seed);
    render::RayCaster caster;
    const auto pictureOf = [&](Document& document, render::Mode mode) {
        View view = document.view();
        view.mode = mode;
        view.shadows = false; // what blocks the light is the scene
        view.tintsSegments = true;
        document.showView(view);
        render::Frame frame = document.frame({200, 150});
        frame.scene.greyWindow = {0, 255}; // of its own histogram otherwise
        frame.samples = 1;
        caster.render(frame);
        document.showView(testCanvas().view);
        return caster.readPicture();
    };
    const auto expectSame = [&](const char* what, bool isCut) {
        ASSERT_EQ(whole.region().labelMap(), roomy.labels()) << what;
        for (const auto mode : {render::Mode::Segment, render::Mode::Overlay, render::Mode::XRay}) {
            const auto wanted = pictureOf(whole, mode);
            for (InBricks* inBricks : {&roomy, &tight}) {
                if (inBricks == &tight && mode != render::Mode::Segment) {
                    continue;
                }
                const auto difference = image::compare(wanted, pictureOf(*inBricks->document, mode));
                // Cut faces, behind which segments go on, do so by rules of values in one and not in the
                // other.
                EXPECT_LT(difference.mean, isCut ? 0.25 : 0.1) << what << int(mode);
                EXPECT_LT(difference.changedFraction, isCut ? 0.02 : 0.01) << what << int(mode);
            }
        }
    };
    const auto applyToAll = [&](const Operation& operation) {
        whole.apply(operation);
        roomy.document->apply(operation);
        tight.document->apply(operation);
    };
    applyToAll(Grow{14});
    expectSame("grown", false);
    UseSegment look;
    look.segment = kFirstSegment;
    look.opacity = 0.4;
    applyToAll(look);
    expectSame("translucent", false);
    look.opacity = 1;
    applyToAll(look);
    applyToAll(Grow{});
    expectSame("grown to the end", false);
    applyToAll(scissorsAt(190, 120, 25));
    expectSame("cut", true);
}

} // namespace
} // namespace vs::studio

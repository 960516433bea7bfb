// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_head.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_growth.h"
#include "studio/state/region.h"

#include <algorithm>

namespace vs::studio {
namespace {

using RegionTest = test::GlTest;
using test::brainSeed;
using test::drillInProbeView;
using test::probeView;
using test::somePeel;
using test::testCanvas;
using test::testHead;

TEST_F(RegionTest, GrowthFillsTheBrainAndStepsBothWaysExactly) {
    Document document(testHead());
    document.apply(brainSeed());
    document.apply(Grow{10});
    const auto ten = document.region().generations();
    document.apply(Grow{});
    const auto all = document.region().generations();
    const auto isBrain = [&](std::size_t i) { return std::uint8_t(document.volume().bytes[i]) == 100; };
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_EQ(all[i] > 0, isBrain(i)) << i;
    }
    const int last = document.facts()->growth.generation;
    document.apply(Rewind{last - 11});
    EXPECT_EQ(document.region().generations(), ten);
    document.apply(Grow{last - 11});
    EXPECT_EQ(document.region().generations(), all);
    document.apply(Undo{});
    EXPECT_EQ(document.region().generations(), ten);
    document.apply(Undo{});
    EXPECT_EQ(document.region().generations(), all);
}

TEST_F(RegionTest, ScrubbingShowsAnyGenerationAndEndsAsOneOperation) {
    Document document(testHead());
    document.apply(brainSeed());
    document.apply(Grow{20});
    const auto whole = document.region().generations();
    const std::size_t logged = document.log().size();
    for (const int generation : {3, 17, 1, 9}) {
        document.growing().scrub(generation);
        document.frame({64, 64});
        auto expected = whole;
        std::replace_if(
            expected.begin(), expected.end(), [&](auto g) { return int(g) > generation; }, 0U);
        EXPECT_TRUE(document.region().generations() == expected) << generation;
    }
    document.growing().endScrub();
    EXPECT_EQ(document.facts()->growth.generation, 9);
    EXPECT_EQ(document.log().size(), logged + 1);
    document.apply(Undo{});
    EXPECT_TRUE(document.region().generations() == whole);
}

TEST_F(RegionTest, GrowthNeverEntersWhatWasCutAway) {
    Document document(testHead());
    document.apply(somePeel(14));
    document.apply(brainSeed());
    document.apply(Grow{});
    const auto labels = document.region().labels();
    const auto cuts = sculpt::valuesOf(test::sculptureBytes(document), sculpt::Precision::Bits16);
    std::size_t fenced = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const bool isCut = cuts[i] >= 0.5F;
        EXPECT_FALSE(isCut && labels[i] == 1);
        fenced += isCut && std::uint8_t(document.volume().bytes[i]) == 100 ? 1 : 0;
    }
    EXPECT_GT(fenced, 50U) << "the peel must reach into the brain for this test to mean anything";
}

TEST_F(RegionTest, LiveGrowthEndsAsOneOperation) {
    Document document(testHead());
    document.apply(brainSeed());
    const auto seeds = document.region().generations();
    document.growing().begin();
    while (document.growing().growFor(0.1, 3)) {
    }
    const Outcome outcome = document.growing().end();
    const auto all = document.region().generations();
    EXPECT_EQ(outcome.voxelsTouched + 1, document.facts()->growth.voxels);
    EXPECT_EQ(document.log().size(), 2U);
    document.apply(Undo{});
    EXPECT_EQ(document.region().generations(), seeds);
    document.apply(Undo{});
    EXPECT_EQ(document.facts()->growth.voxels, 0U);
    document.apply(Redo{});
    document.apply(Redo{});
    EXPECT_EQ(document.region().generations(), all);
}

// Whatever the portions: it ends with the first generation by which the segment has so many voxels, those
// that are only shown again among them.
TEST_F(RegionTest, LiveGrowthEndsWithTheGenerationThatReachesALimit) {
    Document document(testHead());
    document.apply(brainSeed());
    document.apply(Grow{});
    const auto whole = document.region().generations();
    const auto upTo = [&](int generation) {
        return std::size_t(
            std::ranges::count_if(whole, [&](auto g) { return g > 0 && int(g) <= generation; }));
    };
    for (const int kept : {0, 6, 30}) {
        for (const std::size_t limit : {std::size_t(2), upTo(9), upTo(9) + 1, upTo(20) - 1}) {
            Document growing(testHead());
            growing.apply(brainSeed());
            growing.apply(Grow{kept});
            growing.apply(Rewind{kept});
            int expected = 1;
            while (upTo(expected) < limit) {
                ++expected;
            }
            growing.growing().begin();
            while (growing.facts()->growth.voxels < limit) {
                EXPECT_TRUE(growing.growing().growFor(kept == 6 ? 0.01 : 20, 1000, limit));
            }
            growing.growing().end();
            EXPECT_EQ(growing.facts()->growth.generation, expected) << limit << " voxels, kept " << kept;
        }
    }
}

TEST_F(RegionTest, StrokesFindSeedsOnTheVisibleSurface) {
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
    EXPECT_EQ(document.facts()->growth.range, (Range{50, 255})) << "the run takes the displayed range";
}

TEST_F(RegionTest, RedoWorksAfterTheFirstCutOfAProbeView) {
    Document document(testHead());
    document.showView(probeView());
    Seed seed = brainSeed();
    seed.canvas->view = probeView();
    document.apply(seed);
    document.apply(Grow{3});
    const auto grown = document.region().generations();
    document.apply(drillInProbeView());
    for (int i = 0; i < 3; ++i) {
        document.apply(Undo{});
    }
    document.apply(Redo{});
    document.apply(Redo{});
    EXPECT_EQ(document.region().generations(), grown);
    document.apply(Undo{});
    document.apply(Undo{});
    EXPECT_FALSE(document.facts()->canUndo());
}

TEST_F(RegionTest, GrowthIsFencedByTheViewThatItBeganIn) {
    Document document(testHead());
    document.showView(testCanvas().view);
    document.apply(somePeel(14));
    document.apply(brainSeed());
    document.growing().begin();
    document.growing().growFor(0, 2);
    View whole = testCanvas().view;
    whole.sculptureView = field::SculptureView::Whole;
    document.showView(whole); // while it plays
    while (document.growing().growFor(1, 1000)) {
    }
    document.growing().end();
    const auto fenced = document.region().generations();
    document.apply(Undo{});
    document.apply(Redo{});
    EXPECT_EQ(document.region().generations(), fenced);

    Document replayed(testHead());
    for (const Operation& operation : document.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(replayed.region().generations(), fenced);
    EXPECT_EQ(replayed.view(), document.view());
}

TEST_F(RegionTest, RedoOfGrowthKeepsItsFenceWhateverTheViewIsNow) {
    Document document(testHead());
    document.showView(testCanvas().view);
    document.apply(somePeel(14));
    document.apply(brainSeed());
    document.apply(Grow{12});
    const auto fenced = document.region().generations();
    document.apply(Rewind{1});
    document.apply(Grow{1});
    EXPECT_EQ(document.region().generations(), fenced);
    View whole = testCanvas().view;
    whole.sculptureView = field::SculptureView::Whole;
    document.showView(whole);
    for (const int steps : {1, 3}) { // the last growth; the last growth, the rewind and the first
        for (int i = 0; i < steps; ++i) {
            document.apply(Undo{});
        }
        for (int i = 0; i < steps; ++i) {
            document.apply(Redo{});
        }
        EXPECT_EQ(document.region().generations(), fenced);
    }
}

TEST_F(RegionTest, RewindingOnAndOnIsOneStep) {
    Document document(testHead());
    document.apply(brainSeed());
    document.apply(Grow{12});
    const auto grown = document.region().generations();
    for (const int generations : {1, 1, 3}) {
        document.rewindFurther(generations);
    }
    EXPECT_EQ(document.facts()->growth.generation, 8);
    EXPECT_EQ(document.log().size(), 3U);
    const auto rewound = document.region().generations();
    document.apply(Undo{});
    EXPECT_EQ(document.region().generations(), grown);
    document.apply(Redo{});
    EXPECT_EQ(document.region().generations(), rewound);
    Document replayed(testHead());
    for (const Operation& operation : document.log()) {
        replayed.apply(operation);
    }
    EXPECT_EQ(replayed.region().generations(), rewound);
}

TEST_F(RegionTest, AFewSeedsCanBeSeen) {
    Document document(testHead());
    View view = testCanvas({60, 255}).view;
    view.mode = render::Mode::Segment;
    document.showView(view);
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

TEST_F(RegionTest, SeedsOutsideTheGridAreReported) {
    Document document(testHead());
    Seed seed = brainSeed();
    seed.voxels.emplace_back(500, 1, 1);
    EXPECT_NE(document.apply(seed).message.english().find("1 refused"), std::string::npos);
}

} // namespace
} // namespace vs::studio

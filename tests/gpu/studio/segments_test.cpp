// SPDX-License-Identifier: Apache-2.0
// Segments in documents: several of them, their rules and their edits. Brushes and cuts:
// segment_tools_test.cpp.
#include "base/error.h"
#include "base/progress.h"
#include "gpu/gl_test.h"
#include "gpu/studio/test_segments.h"
#include "segment/edits/islands.h"
#include "segment/edits/margins.h"
#include "segment/edits/set_algebra.h"
#include "segment/edits/smoothing.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_growth.h"
#include "studio/document/surface_queries.h"
#include "studio/state/region.h"

#include <functional>

namespace vs::studio {
namespace {

using SegmentsTest = test::GlTest;
using segment::VoxelSet;
using test::editOf;
using test::grownBrain;
using test::refusal;
using test::seedAt;
using test::setOf;
using test::somePeel;
using test::stateOf;
using test::testCanvas;
using test::testHead;

TEST_F(SegmentsTest, NoVoxelIsInTwoAndGrowthStopsAtAnothersBorder) {
    Document document(testHead());
    grownBrain(document, 8);
    const VoxelSet first = setOf(document, 1);
    document.apply(UseSegment{"Other"});
    EXPECT_EQ(document.segments().working().label, 2);
    document.apply(seedAt({35, 60, 29}));
    document.apply(Grow{});
    EXPECT_TRUE(setOf(document, 1) == first);
    const auto map = document.region().labelMap();
    for (std::size_t i = 0; i < map.size(); ++i) {
        ASSERT_EQ(map[i] > 0, std::uint8_t(document.volume().bytes[i]) == 100) << i;
    }
    document.apply(UseSegment{"Segment 1"});
    document.apply(Grow{});
    EXPECT_EQ(document.region().labelMap(), map) << "the other has all the rest";
    EXPECT_NE(document.apply(seedAt({35, 60, 29})).message.english().find("1 refused"), std::string::npos);
    EXPECT_EQ(document.region().labelMap(), map);
}

TEST_F(SegmentsTest, LockedOnesRefuseEveryTool) {
    Document document(testHead());
    grownBrain(document, 8);
    UseSegment lock{"Segment 1"};
    lock.isLocked = true;
    document.apply(lock);
    const auto before = stateOf(document);
    Absorb absorb;
    absorb.voxels = {{35, 20, 29}};
    BrushSegment brush{true, somePeel(2)};
    SetGrowthRules rules;
    rules.range = Range{0, 255};
    for (const Operation& operation : std::vector<Operation>{
             seedAt({35, 58, 29}), Grow{}, Rewind{1}, ShowGeneration{2}, absorb, rules, brush,
             EditSegment{EditSegment::Kind::Margin, 1}, RemoveSegment{"Segment 1"}}) {
        EXPECT_NE(refusal(document, operation).find("'Segment 1' is locked"), std::string::npos)
            << name(operation);
        EXPECT_TRUE(stateOf(document) == before) << name(operation);
    }
    EXPECT_THROW(document.growing().begin(), Error);
    document.apply(UseSegment{"Other"});
    EXPECT_NE(refusal(document, editOf(EditSegment::Kind::Unite, 0, "Segment 1")).find("locked"),
              std::string::npos);
    document.apply(ReSeed{});
    EXPECT_EQ(document.region().labelMap(), before.labelMap) << "clearing all leaves what is locked";
    lock.isLocked = false;
    document.apply(lock);
    document.apply(Grow{1});
    EXPECT_GT(setOf(document, 1).count(), 0U);
    EXPECT_FALSE(document.region().labelMap() == before.labelMap);
}

// Two islands and another segment close by; each edit is what the pure function makes of the voxels, without
// those that belong to another, and comes back by undo and redo.
TEST_F(SegmentsTest, EditsAreThePureFunctions) {
    Document document(testHead());
    grownBrain(document, 9);
    document.apply(seedAt({35, 58, 29}));
    document.apply(Grow{4});
    document.apply(UseSegment{"Other"});
    document.apply(seedAt({46, 24, 29}));
    document.apply(Grow{7});
    document.apply(UseSegment{"Segment 1"});
    const auto& geometry = document.volume().geometry;
    using Kind = EditSegment::Kind;
    using Edit = std::function<VoxelSet(const VoxelSet&, const VoxelSet&)>;
    const auto expectEdit = [&](const EditSegment& op, const Edit& edit) {
        const auto before = stateOf(document);
        const VoxelSet set = setOf(document, 1);
        const VoxelSet other = setOf(document, 2);
        document.apply(op);
        const VoxelSet left = op.kind == Kind::Unite ? VoxelSet{} : other;
        EXPECT_TRUE(setOf(document, 1) == segment::subtract(edit(set, other), left)) << int(op.kind);
        EXPECT_TRUE(setOf(document, 2) == left) << int(op.kind);
        const auto after = stateOf(document);
        EXPECT_FALSE(after == before) << "the edit must do something here: " << int(op.kind);
        document.apply(Undo{});
        EXPECT_TRUE(stateOf(document) == before) << int(op.kind);
        document.apply(Redo{});
        EXPECT_TRUE(stateOf(document) == after) << int(op.kind);
        document.apply(Undo{});
    };
    const auto unary = [&](Kind kind, double amount, const std::function<VoxelSet(const VoxelSet&)>& edit) {
        expectEdit(editOf(kind, amount), [&](const VoxelSet& set, const VoxelSet&) { return edit(set); });
    };
    EditSegment island = editOf(Kind::KeepIsland);
    island.voxel = glm::ivec3(35, 58, 29);
    expectEdit(island, [&](const VoxelSet& s, const VoxelSet&) { return keepIsland(s, *island.voxel); });
    island.kind = Kind::DropIsland;
    expectEdit(island, [&](const VoxelSet& s, const VoxelSet&) { return dropIsland(s, *island.voxel); });
    unary(Kind::KeepLargest, 0, [](const VoxelSet& s) { return segment::keepLargestIsland(s); });
    unary(Kind::DropSmall, 0.4,
          [&](const VoxelSet& s) { return segment::dropSmallIslands(s, geometry, 0.4); });
    unary(Kind::Margin, 2.5, [&](const VoxelSet& s) { return segment::changeMargin(s, geometry, 2.5); });
    unary(Kind::Margin, -1.1, [&](const VoxelSet& s) { return segment::changeMargin(s, geometry, -1.1); });
    unary(Kind::Open, 2, [&](const VoxelSet& s) { return segment::opening(s, geometry, 2); });
    unary(Kind::Close, 12, [&](const VoxelSet& s) { return segment::closing(s, geometry, 12); });
    unary(Kind::Smooth, 2, [&](const VoxelSet& s) { return segment::smooth(s, geometry, 2); });
    unary(Kind::Hollow, 1.3, [&](const VoxelSet& s) { return segment::hollow(s, geometry, 1.3); });
    expectEdit(editOf(Kind::Unite, 0, "Other"),
               [](const VoxelSet& a, const VoxelSet& b) { return segment::unite(a, b); });
    expectEdit(editOf(Kind::Subtract, 6, "Other"), [&](const VoxelSet& a, const VoxelSet& b) {
        return segment::subtract(a, segment::changeMargin(b, geometry, 6));
    });
    expectEdit(editOf(Kind::Intersect, 6, "Other"), [&](const VoxelSet& a, const VoxelSet& b) {
        return segment::intersect(a, segment::changeMargin(b, geometry, 6));
    });
    document.apply(editOf(Kind::Hollow, 1.3)); // now there are holes
    unary(Kind::FillHoles, 0, [&](const VoxelSet& s) { return segment::fillHoles(s, geometry); });
    unary(Kind::FillHoles, 0.2, [&](const VoxelSet& s) { return segment::fillHoles(s, geometry, 0.2); });
}

// In overlay mode the brain is seen through the skull, and can be clicked; in segment mode the skull is in
// front.
TEST_F(SegmentsTest, IslandsAreClickedWhereTheyAreSeen) {
    Document document(testHead());
    grownBrain(document, 60);
    EditSegment island = editOf(EditSegment::Kind::DropIsland);
    island.pixel = glm::dvec2(200, 150);
    island.canvas = test::testCanvas();
    island.canvas->view.mode = render::Mode::Segment;
    EXPECT_NE(refusal(document, island).find("more than 3 voxels away"), std::string::npos);
    EXPECT_GT(setOf(document, 1).count(), 0U);
    island.canvas->view.mode = render::Mode::Overlay;
    document.apply(island);
    EXPECT_EQ(setOf(document, 1).count(), 0U);
}

TEST_F(SegmentsTest, ListEditsRefuseWhatMakesNoSense) {
    Document document(testHead());
    using Kind = EditSegment::Kind;
    EXPECT_EQ(refusal(document, editOf(Kind::Margin, 2)),
              "the segment 'Segment 1' is empty; there is nothing to edit");
    EXPECT_EQ(refusal(document, CutSegment{}),
              "the segment 'Segment 1' is empty; there is nothing to cut by");
    EXPECT_EQ(refusal(document, RemoveSegment{"Liver"}), "there is no segment 'Liver' to remove");
    grownBrain(document, 3);
    document.apply(UseSegment{"Liver"});
    UseSegment rename{"Liver"};
    rename.name = "Segment 1";
    const auto before = stateOf(document);
    EXPECT_EQ(refusal(document, rename), "there is a segment 'Segment 1' already; choose another name");
    rename.segment = "Spleen"; // would have been made first
    EXPECT_EQ(refusal(document, rename), "there is a segment 'Segment 1' already; choose another name");
    for (const char* other : {"", "Liver", "Spleen"}) {
        EXPECT_NE(refusal(document, editOf(Kind::Unite, 0, other)).find("no other segment"),
                  std::string::npos);
    }
    EXPECT_TRUE(stateOf(document) == before);
}

TEST_F(SegmentsTest, AFreshSegmentOwesNothingToARemovedOne) {
    Document document(testHead());
    document.apply(UseSegment{"Segment 2"});
    SetGrowthRules rules;
    rules.difference = Range{0, 0};
    rules.isLive = true;
    document.apply(rules);
    document.apply(seedAt({35, 20, 29}, {30, 120}));
    document.apply(Grow{});
    const std::size_t brain = document.facts()->growth.voxels;
    document.apply(RemoveSegment{"Segment 2"});
    EXPECT_EQ(setOf(document, 2).count(), 0U);
    document.apply(UseSegment{"Segment 3"});
    EXPECT_EQ(document.segments().working().label, 2) << "the number is free again";
    document.apply(seedAt({35, 20, 29}, {30, 120}));
    document.apply(Grow{});
    EXPECT_GT(document.facts()->growth.voxels, brain) << "without the rule it enters the core";
    while (document.facts()->canUndo()) {
        document.apply(Undo{});
    }
    while (document.facts()->canRedo()) {
        document.apply(Redo{});
    }
    EXPECT_GT(document.facts()->growth.voxels, brain);
}

TEST_F(SegmentsTest, OneIsShownAloneOrAllAre) {
    Document document(testHead());
    for (const char* name : {"Liver", "Spleen", "Heart"}) {
        document.apply(UseSegment{name});
    }
    const auto shown = [&] {
        std::string names;
        for (const SegmentInfo& segment : document.segments().segments) {
            names += segment.isVisible ? segment.name + " " : "";
        }
        return names;
    };
    document.apply(ShowSegments{"Spleen"});
    EXPECT_EQ(shown(), "Spleen ");
    EXPECT_EQ(document.segments().working().name, "Heart") << "goes on at work";
    document.apply(Undo{});
    EXPECT_EQ(shown(), "Liver Spleen Heart ");
    document.apply(Redo{});
    EXPECT_EQ(shown(), "Spleen ");
    document.apply(ShowSegments{});
    EXPECT_EQ(shown(), "Liver Spleen Heart ");
    EXPECT_EQ(refusal(document, ShowSegments{"Kidney"}), "there is no segment 'Kidney' to show");
    EXPECT_EQ(shown(), "Liver Spleen Heart ");
}

// Wherever a stroke lies on what is seen of the segment, it takes something: its smooth surface runs up to a
// voxel beside the segment's voxels.
TEST_F(SegmentsTest, StrokesOnASegmentAbsorbIt) {
    Document document(testHead());
    const Canvas canvas = testCanvas();
    Seed seed = seedAt({35, 10, 29});
    seed.range = Range{150, 255}; // the skull's shell
    document.apply(seed);
    document.apply(Grow{});
    SetView view;
    view.mode = render::Mode::Segment;
    view.camera = canvas.view.camera;
    document.apply(view);
    const auto voxels = [&] { return document.facts()->growth.voxels; };
    const std::size_t whole = voxels();
    int tried = 0;
    for (double y = 80; y <= 200; y += 8) {
        for (double x = 130; x <= 270; x += 10) {
            Absorb absorb;
            absorb.strokes = {{Shape::FreeForm, {{x, y}, {x + 2, y}}}};
            absorb.widthPixels = 1;
            absorb.expansions = 1;
            absorb.canvas = canvas;
            absorb.canvas->view.mode = render::Mode::Segment;
            if (!document.surface().probe({x, y}, canvas.viewport)) {
                continue; // beside it
            }
            document.apply(absorb);
            EXPECT_LT(voxels(), whole) << "at " << x << ", " << y;
            document.apply(Undo{});
            ASSERT_EQ(voxels(), whole);
            ++tried;
        }
    }
    EXPECT_GT(tried, 50);
}

TEST_F(SegmentsTest, AbsorbedVoxelsStayAwayUntilSeededAgain) {
    Document document(testHead());
    grownBrain(document, 12);
    const auto generations = document.region().generations();
    Absorb absorb;
    absorb.voxels = {{35, 20, 29}}; // the seed, generation 1: each expansion takes one generation more
    absorb.expansions = 4;
    constexpr std::uint32_t kLast = 5;
    document.apply(absorb);
    const auto labels = document.region().labels();
    for (std::size_t i = 0; i < labels.size(); ++i) {
        ASSERT_EQ(labels[i] == 1, generations[i] > kLast) << i;
    }
    document.apply(Grow{});
    const auto grown = document.region().labels();
    for (std::size_t i = 0; i < grown.size(); ++i) {
        ASSERT_FALSE(grown[i] == 1 && generations[i] > 0 && generations[i] <= kLast) << i;
    }
    document.apply(seedAt({35, 20, 29}));
    EXPECT_EQ(setOf(document, 1).contains({35, 20, 29}), true);
}

TEST_F(SegmentsTest, ScrubbingShowsGenerations) {
    Document document(testHead());
    grownBrain(document, 12);
    const auto all = document.region().generations();
    for (const int generation : {5, 0, 9, 500}) {
        document.apply(ShowGeneration{generation});
        const auto shown = document.region().generations();
        for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_EQ(shown[i], all[i] <= std::uint32_t(generation) ? all[i] : 0) << i;
        }
    }
    document.apply(ShowGeneration{5});
    document.apply(Grow{8});
    EXPECT_EQ(document.region().generations(), all) << "growing goes on from there";
}

TEST_F(SegmentsTest, LiveRulesTakeBackWhatTheyDoNotReach) {
    Document document(testHead());
    document.apply(seedAt({35, 20, 29}, {30, 120})); // brain and its core of 40
    document.apply(Grow{});
    const auto both = document.region().labels();
    SetGrowthRules rules;
    rules.range = Range{80, 120};
    document.apply(rules);
    EXPECT_EQ(document.region().labels(), both) << "not live: only what comes obeys them";
    document.apply(Undo{});
    rules.isLive = true;
    document.apply(rules);
    const auto& bytes = document.volume().bytes;
    const auto brain = document.region().labels();
    for (std::size_t i = 0; i < brain.size(); ++i) {
        ASSERT_EQ(brain[i] == 1, std::uint8_t(bytes[i]) == 100) << i;
    }
    SetGrowthRules wide;
    wide.range = Range{30, 120};
    wide.difference = Range{-5, 5}; // the core is 60 below
    document.apply(wide);
    document.apply(Grow{});
    EXPECT_EQ(document.region().labels(), brain);
    SetGrowthRules drop;
    drop.difference = std::optional<Range>();
    document.apply(drop);
    document.apply(Grow{});
    EXPECT_EQ(document.region().labels(), both);
}

// The operation before too, where the one that is given up was to take its place.
TEST_F(SegmentsTest, WhatIsGivenUpLeavesEverythingAsItWas) {
    using Kind = EditSegment::Kind;
    Document document(testHead());
    grownBrain(document, 8);
    document.apply(editOf(Kind::Margin, 2));
    const auto before = stateOf(document);
    const std::size_t logged = document.log().size();
    const auto expectAsBefore = [&] {
        EXPECT_TRUE(stateOf(document) == before);
        EXPECT_EQ(document.log().size(), logged);
        EXPECT_EQ(document.facts()->edits->done, document.facts()->edits->operations.size());
    };
    for (const Operation& operation :
         {Operation(editOf(Kind::Close, 3)), Operation(editOf(Kind::KeepLargest)), Operation(CutSegment{})}) {
        const ProgressListener givesUp([](auto) { return false; });
        EXPECT_THROW(document.apply(operation), GivenUp) << name(operation);
        expectAsBefore();
    }
    {
        const ProgressListener givesUp([](auto) { return false; });
        EXPECT_THROW(document.replaceLast(editOf(Kind::Close, 3)), GivenUp);
    }
    expectAsBefore();
    document.apply(Undo{});
    const auto undone = stateOf(document);
    {
        const ProgressListener givesUp([](auto) { return false; });
        EXPECT_THROW(document.apply(Redo{}), GivenUp);
    }
    EXPECT_TRUE(stateOf(document) == undone);
    document.apply(Redo{});
    EXPECT_TRUE(stateOf(document) == before);
}

} // namespace
} // namespace vs::studio

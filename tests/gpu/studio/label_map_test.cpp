// SPDX-License-Identifier: Apache-2.0
// Segments from a label map, and edits that take the place of the last one.
#include "gpu/gl_test.h"
#include "gpu/studio/test_labels.h"
#include "gpu/studio/test_segments.h"
#include "studio/document/document_facts.h"
#include "studio/json/session.h"
#include "studio/state/region.h"

namespace vs::studio {
namespace {

using LoadLabelsTest = test::GlTest;
using ReplaceLastTest = test::GlTest;
using test::grownBrain;
using test::LabelFile;
using test::refusal;
using test::setOf;
using test::stateOf;
using test::testHead;

TEST_F(LoadLabelsTest, EachLabelBecomesASegmentAndUndoTakesThemBack) {
    const LabelFile file;
    Document document(testHead());
    const auto before = stateOf(document);
    document.apply(LoadLabels{file.path()});
    const auto& list = document.segments().segments;
    ASSERT_EQ(list.size(), 2U) << "the empty one is used";
    EXPECT_EQ(list[0].name, "Label 7");
    EXPECT_EQ(list[1].name, "Label 250");
    const auto map = document.region().labelMap();
    for (std::size_t i = 0; i < map.size(); ++i) {
        const int value = LabelFile::valueAt(int(i), document.volume().geometry.dims);
        ASSERT_EQ(map[i], value == 7 ? 1 : value == 250 ? 2 : 0) << i;
    }
    const auto after = stateOf(document);
    document.apply(Undo{});
    EXPECT_TRUE(stateOf(document) == before);
    std::filesystem::remove(file.path());
    document.apply(Redo{});
    EXPECT_TRUE(stateOf(document) == after) << "without the file";
}

TEST_F(LoadLabelsTest, WhatIsThereStays) {
    const LabelFile file;
    Document document(testHead());
    grownBrain(document, 8);
    const auto brain = setOf(document, 1);
    document.apply(LoadLabels{file.path()});
    ASSERT_EQ(document.segments().segments.size(), 3U);
    EXPECT_EQ(document.segments().working().name, "Segment 1");
    EXPECT_TRUE(setOf(document, 1) == brain);
    const auto map = document.region().labelMap();
    for (std::size_t i = 0; i < map.size(); ++i) {
        const int value = LabelFile::valueAt(int(i), document.volume().geometry.dims);
        ASSERT_EQ(map[i], map[i] == 1 ? 1 : value == 7 ? 2 : value == 250 ? 3 : 0) << i;
    }
    document.apply(LoadLabels{file.path()});
    EXPECT_EQ(document.segments().segments.back().name, "Label 250 (2)");
}

TEST_F(LoadLabelsTest, AnotherFileOrGridIsRefused) {
    const LabelFile file;
    Document document(testHead());
    const auto before = stateOf(document);
    EXPECT_NE(refusal(document, LoadLabels{file.path(), "0123456789abcdef"}).find("is not the label map"),
              std::string::npos);
    EXPECT_NE(refusal(document, LoadLabels{"/no/such.nrrd"}).find("/no/such.nrrd"), std::string::npos);
    volume::GridGeometry small = document.volume().geometry;
    small.dims = glm::ivec3(4);
    const std::vector<std::uint8_t> labels(64, 1);
    volume::writeGrid(file.path(), small, std::span<const std::uint8_t>(labels));
    EXPECT_NE(refusal(document, LoadLabels{file.path()}).find("labels must lie on the volume's grid"),
              std::string::npos);
    EXPECT_TRUE(stateOf(document) == before);
    EXPECT_FALSE(document.facts()->canUndo());
}

// A session names the file relative to itself, so that both can move together.
TEST_F(LoadLabelsTest, SessionsFindTheFileBesideThem) {
    const LabelFile file;
    const auto folder = file.path().parent_path();
    const auto saved = folder / ("vs_labels_session_" + std::to_string(getpid()) + ".json");
    Document document(testHead());
    document.apply(LoadLabels{file.path()});
    Session source;
    source.volumePath = folder / "head.raw";
    saveSession(saved, sessionOf(document, source));
    const Session loaded = loadSession(saved);
    std::filesystem::remove(saved);
    const auto& operation = std::get<LoadLabels>(loaded.operations.front());
    EXPECT_EQ(operation.path.lexically_normal(), file.path().lexically_normal());
    EXPECT_EQ(operation.map, nullptr);
    Document again(testHead());
    for (const Operation& one : loaded.operations) {
        again.apply(one);
    }
    EXPECT_TRUE(stateOf(again) == stateOf(document));
}

SetGrowthRules liveRange(Range range) {
    SetGrowthRules rules;
    rules.range = range;
    rules.isLive = true;
    return rules;
}

// A drag of a slider, however it went, is its last value.
TEST_F(ReplaceLastTest, OnlyTheLastOneWasEverDone) {
    Document dragged(testHead());
    dragged.apply(test::seedAt({35, 20, 29}, {30, 120}));
    dragged.apply(Grow{});
    const auto before = stateOf(dragged);
    const std::size_t steps = dragged.history().statistics().steps;
    const std::size_t logged = dragged.log().size();
    dragged.apply(liveRange({110, 120}));
    for (const double lo : {100.0, 60.0, 105.0, 80.0}) {
        dragged.replaceLast(liveRange({lo, 120}));
    }
    EXPECT_EQ(dragged.history().statistics().steps, steps + 1);
    EXPECT_EQ(dragged.log().size(), logged + 1);

    Document plain(testHead());
    plain.apply(test::seedAt({35, 20, 29}, {30, 120}));
    plain.apply(Grow{});
    plain.apply(liveRange({80, 120}));
    EXPECT_TRUE(stateOf(dragged) == stateOf(plain));
    dragged.apply(Undo{});
    EXPECT_TRUE(stateOf(dragged) == before);
    dragged.apply(Redo{});
    EXPECT_TRUE(stateOf(dragged) == stateOf(plain));
}

// What a file holds stays as it is: what comes after saving is an edit of its own.
TEST_F(ReplaceLastTest, WhatWasSavedStays) {
    Document document(testHead());
    grownBrain(document, 6);
    document.rewindFurther(1);
    document.seal();
    const std::size_t logged = document.log().size();
    document.rewindFurther(1);
    document.rewindFurther(1);
    ASSERT_EQ(document.log().size(), logged + 1);
    EXPECT_EQ(std::get<Rewind>(document.log()[logged - 1]).generations, 1);
    EXPECT_EQ(std::get<Rewind>(document.log()[logged]).generations, 2);
    document.apply(liveRange({100, 120}));
    document.seal();
    document.replaceLast(liveRange({90, 120}));
    document.replaceLast(liveRange({80, 120}));
    EXPECT_EQ(document.log().size(), logged + 3);
}

TEST_F(ReplaceLastTest, OfAnotherKindIsDoneAfterIt) {
    Document document(testHead());
    grownBrain(document, 6);
    const std::size_t steps = document.history().statistics().steps;
    document.replaceLast(UseSegment{"Liver"});
    EXPECT_EQ(document.history().statistics().steps, steps + 1);
    EXPECT_GT(setOf(document, 1).count(), 0U);
}

TEST_F(ReplaceLastTest, WhatIsRefusedLeavesTheLastOne) {
    Document document(testHead());
    document.apply(UseSegment{"Liver"});
    document.apply(UseSegment{"Spleen"});
    UseSegment taken{"Spleen"};
    taken.name = "Liver";
    const auto before = stateOf(document);
    EXPECT_THROW(document.replaceLast(taken), Error);
    EXPECT_TRUE(stateOf(document) == before);
    EXPECT_EQ(document.log().size(), 2U);
}

TEST_F(ReplaceLastTest, LooksOfAnotherSegmentLeaveWorkWhereItIs) {
    Document document(testHead());
    grownBrain(document, 9);
    document.apply(ShowGeneration{4});
    document.apply(UseSegment{"Other"});
    document.apply(Undo{});
    UseSegment hide{"Segment 1"};
    hide.isVisible = false;
    hide.goesToWork = false;
    document.apply(UseSegment{"Other"});
    document.apply(hide);
    EXPECT_EQ(document.segments().working().name, "Other");
    EXPECT_FALSE(document.segments().find("Segment 1")->isVisible);
}

} // namespace
} // namespace vs::studio

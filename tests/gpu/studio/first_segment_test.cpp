// SPDX-License-Identifier: Apache-2.0
// The segment that is there at first, and the one that is named first.
#include "gpu/gl_test.h"
#include "gpu/studio/test_segments.h"
#include "studio/json/session.h"
#include "studio/state/region.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace vs::studio {
namespace {

using FirstSegment = test::GlTest;
using test::refusal;
using test::seedAt;
using test::testHead;

std::vector<std::string> namesOf(const Document& document) {
    std::vector<std::string> names;
    for (const SegmentInfo& segment : document.segments().segments) {
        names.push_back(fmt::format("{} {}", segment.label, segment.name));
    }
    return names;
}
using Names = std::vector<std::string>;

TEST_F(FirstSegment, GivesItsPlaceToTheFirstThatIsNamed) {
    Document document(testHead());
    document.apply(UseSegment{"Brain"});
    EXPECT_EQ(namesOf(document), (Names{"1 Brain"}));
    document.apply(seedAt({35, 20, 29}));
    document.apply(UseSegment{"Skull"});
    EXPECT_EQ(namesOf(document), (Names{"1 Brain", "2 Skull"}));
    EXPECT_EQ(document.region().labelMap()[std::size_t(
                  (29 * document.volume().geometry.dims.y + 20) * document.volume().geometry.dims.x + 35)],
              1);
}

TEST_F(FirstSegment, StaysBesideOneThatIsNumberedOrDoesNotGoToWork) {
    Document document(testHead());
    document.apply(UseSegment{"Segment 2"});
    EXPECT_EQ(namesOf(document), (Names{"1 Segment 1", "2 Segment 2"}));
    document.apply(Undo{});
    UseSegment beside{"Brain"};
    beside.goesToWork = false;
    document.apply(beside);
    EXPECT_EQ(namesOf(document), (Names{"1 Segment 1", "2 Brain"}));
    document.apply(Undo{});
    UseSegment further{"Brain"};
    further.takesFirst = false;
    document.apply(further);
    EXPECT_EQ(namesOf(document), (Names{"1 Segment 1", "2 Brain"}));
}

TEST_F(FirstSegment, StaysOnceSomethingWasDoneWithIt) {
    UseSegment colour{"Segment 1"};
    colour.colour = glm::dvec3(1, 0, 0);
    SetGrowthRules rules;
    rules.gradient = Range{0, 10};
    for (const Operation& operation : std::vector<Operation>{seedAt({35, 20, 29}), colour, rules}) {
        Document document(testHead());
        document.apply(operation);
        document.apply(UseSegment{"Brain"});
        EXPECT_EQ(namesOf(document), (Names{"1 Segment 1", "2 Brain"})) << name(operation);
        document.apply(Undo{});
        document.apply(Undo{}); // untouched again
        document.apply(UseSegment{"Brain"});
        EXPECT_EQ(namesOf(document), (Names{"1 Brain"})) << name(operation);
        UseSegment wanted{"Skull"};
        wanted.takesFirst = true;
        EXPECT_NE(refusal(document, wanted).find("leave 'first' out"), std::string::npos);
    }
}

TEST_F(FirstSegment, ComesBackByUndoAndGoesAgainByRedo) {
    Document document(testHead());
    document.apply(UseSegment{"Brain"});
    const SegmentList named = document.segments();
    document.apply(Undo{});
    EXPECT_EQ(namesOf(document), (Names{"1 Segment 1"}));
    document.apply(Redo{});
    EXPECT_TRUE(document.segments() == named);
    document.apply(Undo{});
    document.apply(UseSegment{"Skull"});
    EXPECT_EQ(namesOf(document), (Names{"1 Skull"}));
}

TEST_F(FirstSegment, LabelsThatAreLoadedLeaveTheOneThatWasNamed) {
    volume::LabelMap map;
    map.geometry = testHead().geometry;
    map.labels.assign(map.geometry.voxelCount(), 0);
    map.labels[1000] = 1;
    map.values = {0, 7};
    LoadLabels labels;
    labels.map = std::make_shared<volume::LabelMap>(map);
    Document document(testHead());
    document.apply(UseSegment{"Brain"});
    document.apply(labels);
    EXPECT_EQ(namesOf(document), (Names{"1 Brain", "2 Label 7"}));
    // As ever for one that was only renamed.
    Document renamed(testHead());
    UseSegment rename{"Segment 1"};
    rename.name = "Brain";
    renamed.apply(rename);
    renamed.apply(labels);
    EXPECT_EQ(namesOf(renamed), (Names{"1 Label 7"}));
}

Names replayed(const std::string& operations) {
    const auto path =
        std::filesystem::temp_directory_path() / fmt::format("vs_first_segment_{}.json", getpid());
    std::ofstream(path) << R"({"volumeStudioSession": 1, "volume": {"path": "head.nrrd"}, "operations": [)"
                        << operations << "]}";
    Document document(testHead());
    Session again;
    for (const Operation& operation : loadSession(path).operations) {
        document.apply(operation);
    }
    // What is saved replays to the same.
    again.volumePath = "head.nrrd";
    again.operations = document.log();
    saveSession(path, again);
    Document second(testHead());
    for (const Operation& operation : loadSession(path).operations) {
        second.apply(operation);
    }
    EXPECT_TRUE(second.segments() == document.segments()) << operations;
    return namesOf(document);
}

TEST_F(FirstSegment, OfSessionsIsThereWhereTheySpeakOfIt) {
    const std::string brain = R"({"op": "segment", "segment": "Brain"})";
    EXPECT_EQ(replayed(brain), (Names{"1 Brain"}));
    const Names both{"1 Segment 1", "2 Brain"};
    EXPECT_EQ(replayed(brain + R"(, {"op": "segment", "segment": "Segment 1"})"), both);
    EXPECT_EQ(replayed(brain + R"(, {"op": "edit segment", "edit": "unite", "other": "Segment 1"})"), both);
    EXPECT_EQ(replayed(brain + R"(, {"op": "remove segment", "segment": "Segment 1"})"), (Names{"2 Brain"}));
    // As the window wrote it before it said `first`.
    EXPECT_EQ(replayed(R"({"op": "segment", "segment": "Segment 2"})"),
              (Names{"1 Segment 1", "2 Segment 2"}));
    // A name that it gets back by the way does not count: the first is made anew when the last one goes.
    EXPECT_EQ(replayed(brain + R"(, {"op": "remove segment", "segment": "Brain"}, )" + brain),
              (Names{"1 Brain"}));
}

} // namespace
} // namespace vs::studio

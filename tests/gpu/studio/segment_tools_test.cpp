// SPDX-License-Identifier: Apache-2.0
// Segments and the sculpture: brushes, cuts by a segment, and all of it undone, redone and replayed.
#include "gpu/gl_test.h"
#include "gpu/studio/test_labels.h"
#include "gpu/studio/test_segments.h"
#include "segment/edits/margins.h"
#include "segment/edits/set_algebra.h"
#include "studio/json/operation_json.h"

#include <nlohmann/json.hpp>

#include <random>

namespace vs::studio {
namespace {

using SegmentToolsTest = test::GlTest;
using segment::VoxelSet;
using test::editOf;
using test::ellipseAt;
using test::grownBrain;
using test::seedAt;
using test::setOf;
using test::somePeel;
using test::stateOf;
using test::testCanvas;
using test::testHead;
using Stroke = decltype(BrushSegment::stroke);

VoxelSet cutIn(const Document& document) {
    const auto values = sculpt::valuesOf(document.sculptureBytes(), document.precision());
    VoxelSet set = segment::emptySet(document.volume().geometry.box());
    for (std::size_t i = 0; i < values.size(); ++i) {
        set.inside[i] = values[i] >= 0.5F ? 1 : 0;
    }
    return set;
}

VoxelSet inRange(const Document& document, const Range& range) {
    VoxelSet set = segment::emptySet(document.volume().geometry.box());
    for (std::size_t i = 0; i < set.inside.size(); ++i) {
        set.inside[i] = range.contains(double(std::uint8_t(document.volume().bytes[i]))) ? 1 : 0;
    }
    return set;
}

std::vector<Stroke> strokes() {
    Drill drill = test::drillOf(ellipseAt(200, 150, 15, 12), testCanvas());
    Laser laser;
    laser.mask = ellipseAt(190, 140, 12, 12);
    laser.canvas = testCanvas();
    Scissors scissors{ellipseAt(210, 130, 25, 20)};
    scissors.depth = 9;
    scissors.canvas = testCanvas();
    return {somePeel(6), drill, laser, scissors};
}

// Against a second document in which the same stroke really cuts, after the same cut before.
TEST_F(SegmentToolsTest, BrushesTakeWhatTheStrokeWouldCut) {
    for (const Stroke& stroke : strokes()) {
        Document document(testHead());
        Document cut(testHead());
        const Drill before = test::drillOf(ellipseAt(215, 140, 9, 9), testCanvas());
        document.apply(before);
        cut.apply(before);
        const VoxelSet gone = cutIn(cut);
        std::visit([&](const auto& op) { cut.apply(op); }, stroke);
        const VoxelSet crossing = segment::subtract(cutIn(cut), gone);
        ASSERT_GT(crossing.count(), 50U);
        document.apply(UseSegment{"Segment 2"});
        document.apply(seedAt({35, 68, 29}, {150, 255}));
        document.apply(Grow{12}); // some skull
        document.apply(UseSegment{"Segment 1"});
        const VoxelSet other = setOf(document, 2);
        const auto untouched = stateOf(document);

        document.apply(BrushSegment{true, stroke});
        const VoxelSet added = segment::intersect(crossing, inRange(document, {50, 255}));
        EXPECT_TRUE(setOf(document, 1) == segment::subtract(added, other));
        EXPECT_TRUE(setOf(document, 2) == other);
        EXPECT_TRUE(document.sculptureBytes() == untouched.sculpture);
        const auto brushed = stateOf(document);
        document.apply(Undo{});
        EXPECT_TRUE(stateOf(document) == untouched);
        document.apply(Redo{});
        EXPECT_TRUE(stateOf(document) == brushed);

        document.apply(ReSeed{});
        document.apply(UseSegment{"All"});
        document.apply(seedAt({35, 20, 29}, {5, 255}));
        document.apply(Grow{});
        const VoxelSet all = setOf(document, 3);
        EXPECT_GT(segment::intersect(all, crossing).count(), 50U);
        document.apply(BrushSegment{false, stroke});
        EXPECT_TRUE(setOf(document, 3) == segment::subtract(all, crossing));
        EXPECT_TRUE(document.sculptureBytes() == untouched.sculpture);
    }
}

TEST_F(SegmentToolsTest, CutsFollowTheSegmentExactly) {
    for (const auto precision :
         {sculpt::Precision::Bits8, sculpt::Precision::Bits16, sculpt::Precision::Bits32}) {
        Document document(testHead(), precision);
        grownBrain(document, 9);
        const auto& geometry = document.volume().geometry;
        const VoxelSet whole = [&] {
            VoxelSet set = segment::emptySet(geometry.box());
            set.inside.assign(set.inside.size(), 1);
            return set;
        }();
        const VoxelSet set = setOf(document, 1);
        const auto before = stateOf(document);
        for (const double margin : {0.0, 2.5, -1.1}) {
            const VoxelSet meant = segment::changeMargin(set, geometry, margin);
            for (const bool keeps : {false, true}) {
                document.apply(CutSegment{keeps, margin});
                EXPECT_TRUE(cutIn(document) == (keeps ? segment::subtract(whole, meant) : meant))
                    << margin << keeps;
                const auto after = stateOf(document);
                EXPECT_EQ(after.labelMap, before.labelMap);
                document.apply(Undo{});
                EXPECT_TRUE(stateOf(document) == before) << margin << keeps;
                document.apply(Redo{});
                EXPECT_TRUE(stateOf(document) == after) << margin << keeps;
                document.apply(Undo{});
            }
        }
    }
}

Operation someOperation(std::mt19937& random, const std::filesystem::path& labels) {
    const auto below = [&](unsigned n) { return int(random() % n); };
    const std::string names[] = {"Segment 1", "B", "C"};
    const std::string& who = names[below(3)];
    const auto brainVoxel = [&] { return glm::ivec3(30 + below(12), 16 + below(6), 24 + below(12)); };
    const auto trail = [&] {
        Trail way{{brainVoxel(), brainVoxel()}, 0.5 * below(9)};
        if (below(2) == 0) {
            way.axis = below(3);
        }
        return way;
    };
    switch (below(17)) {
    case 0: {
        UseSegment use{who};
        use.isLocked = below(4) == 0;
        use.opacity = 0.25 * (1 + below(4));
        use.goesToWork = below(2) == 0;
        return use;
    }
    case 1:
        return UseSegment{who};
    case 2:
    case 3:
        return seedAt(brainVoxel());
    case 4:
    case 5:
        return Grow{1 + below(6)};
    case 6:
        return Rewind{below(5)};
    case 7:
        return ShowGeneration{below(12)};
    case 8: {
        SetGrowthRules rules;
        rules.isLive = below(2) == 0;
        rules.range = below(2) == 0 ? Range{80, 120} : Range{30, 255};
        rules.connectivity = below(2) == 0 ? 6 : 26;
        return rules;
    }
    case 9: {
        Absorb absorb;
        absorb.voxels = {brainVoxel()};
        absorb.expansions = 1 + below(4);
        absorb.canvas = testCanvas();
        return absorb;
    }
    case 10:
        return below(3) == 0 ? Operation(RemoveSegment{who}) : Operation(somePeel(1 + below(4)));
    case 11: {
        EditSegment edit = editOf(EditSegment::Kind(below(13)), 0.5 + below(3), who);
        edit.voxel = brainVoxel();
        return edit;
    }
    case 12: {
        Seed seed;
        seed.trails = {trail(), trail()};
        seed.range = Range{80, 120};
        seed.canvas = testCanvas();
        return seed;
    }
    case 13: {
        PaintSegment paint{below(3) > 0, trail()};
        if (below(2) == 0) {
            paint.range = Range{80, 120};
        }
        return paint;
    }
    case 14:
        return BrushSegment{below(2) == 0, strokes()[std::size_t(below(4))]};
    case 15:
        return below(3) == 0 ? Operation(LoadLabels{labels}) : Operation(Grow{1 + below(6)});
    default:
        return below(8) == 0 ? Operation(ReSeed{}) : Operation(CutSegment{below(3) == 0, double(below(3))});
    }
}

// Grows or plays backward as the window does, or by an operation.
void applySome(Document& document, const Operation& operation, std::mt19937& random) {
    if (std::holds_alternative<Grow>(operation) && random() % 3 == 0) {
        document.beginGrowth();
        document.growFor(1, 4);
        document.endGrowth();
    } else {
        document.apply(operation);
    }
}

// Whatever was done: undo and redo bring back every state, what is refused leaves no trace, and the log,
// written and read again, does it all once more.
void undoRedoAndReplay(unsigned seed) {
    const test::LabelFile labels;
    std::mt19937 random(seed);
    Document document(testHead());
    std::vector<test::DocumentState> states{stateOf(document)};
    std::size_t at = 0;
    int refused = 0;
    int travels = 0;
    for (int n = 0; n < 60; ++n) {
        const Operation operation = someOperation(random, labels.path());
        try {
            applySome(document, operation, random);
        } catch (const Error&) {
            ++refused;
        }
        const auto now = stateOf(document);
        if (!document.canRedo() && document.undoStatistics().steps == at + 1) { // a step was made
            states.resize(++at);
            states.push_back(now);
        } else {
            ASSERT_TRUE(now == states[at]) << n << " left a trace: " << name(operation);
        }
        for (int moves = int(random() % 3); moves > 0; --moves) {
            const bool back = random() % 2 == 0;
            if (back ? document.canUndo() : document.canRedo()) {
                const std::string what = back ? name(*document.lastEdit()) : "";
                document.apply(back ? Operation(Undo{}) : Operation(Redo{}));
                at += back ? std::size_t(-1) : 1;
                ++travels;
                const auto state = stateOf(document);
                ASSERT_TRUE(state.segments == states[at].segments) << n << " " << what;
                ASSERT_TRUE(state.sculpture == states[at].sculpture) << n << " " << what;
                ASSERT_TRUE(state.labelMap == states[at].labelMap) << n << " " << what;
                ASSERT_TRUE(state.generations == states[at].generations) << n << " " << what;
            }
        }
    }
    EXPECT_LT(refused, 40);
    EXPECT_GT(travels, 15);
    Document replayed(testHead());
    for (const Operation& operation : document.log()) {
        replayed.apply(operationFromJson(toJson(operation), "log"));
    }
    EXPECT_TRUE(stateOf(replayed) == stateOf(document));
    while (document.canUndo()) {
        document.apply(Undo{});
        ASSERT_TRUE(stateOf(document) == states[--at]) << "back at " << at;
    }
}

TEST_F(SegmentToolsTest, UndoRedoAndReplayOfAnything) {
    for (unsigned seed = 5; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        undoRedoAndReplay(seed);
    }
}

} // namespace
} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
// Segments and the sculpture: brushes and cuts by a segment, undone and redone.
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_segments.h"
#include "segment/edits/margins.h"
#include "segment/edits/set_algebra.h"

namespace vs::studio {
namespace {

using SegmentToolsTest = test::GlTest;
using segment::VoxelSet;
using test::ellipseAt;
using test::grownBrain;
using test::inRange;
using test::seedAt;
using test::setOf;
using test::stateOf;
using test::Stroke;
using test::strokes;
using test::testCanvas;
using test::testHead;

VoxelSet cutIn(const Document& document) {
    const auto values = sculpt::valuesOf(test::sculptureBytes(document), document.sculpture().precision());
    VoxelSet set = segment::emptySet(document.volume().geometry.box());
    for (std::size_t i = 0; i < values.size(); ++i) {
        set.inside[i] = values[i] >= 0.5F ? 1 : 0;
    }
    return set;
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
        EXPECT_TRUE(test::sculptureBytes(document) == untouched.sculpture);
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
        EXPECT_TRUE(test::sculptureBytes(document) == untouched.sculpture);
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

} // namespace
} // namespace vs::studio

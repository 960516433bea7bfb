// SPDX-License-Identifier: Apache-2.0
// Round brushes: segments painted and seeds placed with them.
#include "gpu/gl_test.h"
#include "gpu/studio/test_segments.h"
#include "segment/edits/set_algebra.h"
#include "studio/operations/trail.h"

namespace vs::studio {
namespace {

using PaintingTest = test::GlTest;
using segment::VoxelSet;
using test::editOf;
using test::inRange;
using test::setOf;
using test::stateOf;
using test::testHead;

// A disc on a slice, against the distance of every voxel of it.
TEST_F(PaintingTest, PaintsWhatLiesUnderTheBrush) {
    Document document(testHead());
    const auto& geometry = document.volume().geometry;
    const std::vector<glm::dvec3> way{{30.25, 20, 30}, {41, 22.5, 30.4}};
    const auto meant = [&](double radius, bool isDisc, const std::optional<Range>& range) {
        VoxelSet set = segment::emptySet(geometry.box());
        const glm::dvec3 mm = geometry.spacing();
        for (std::size_t i = 0; i < set.inside.size(); ++i) {
            const glm::ivec3 voxel = set.voxelAt(i);
            const glm::dvec3 a = isDisc ? glm::dvec3(glm::dvec2(way[0]), 30) : way[0];
            const glm::dvec3 b = isDisc ? glm::dvec3(glm::dvec2(way[1]), 30) : way[1];
            double nearest = 1e9;
            for (int n = 0; n <= 1000; ++n) {
                nearest =
                    std::min(nearest, glm::length(mm * (glm::dvec3(voxel) - glm::mix(a, b, n / 1000.0))));
            }
            const bool isUnder = nearest <= radius && (!isDisc || voxel.z == 30);
            set.inside[i] = isUnder && (!range || range->contains(document.volume().at(voxel))) ? 1 : 0;
        }
        return set;
    };
    for (const bool isDisc : {true, false}) {
        for (const auto& range : {std::optional<Range>(), std::optional(Range{80, 120})}) {
            const auto before = stateOf(document);
            PaintSegment paint{true, {way, 5.02}, range};
            if (isDisc) {
                paint.trail.axis = 2;
            }
            document.apply(paint);
            EXPECT_TRUE(setOf(document, 1) == meant(5.02, isDisc, range)) << isDisc << bool(range);
            EXPECT_GT(setOf(document, 1).count(), 20U);
            paint.isToAdd = false;
            paint.trail.radiusMm = 2.01;
            paint.range.reset();
            document.apply(paint);
            EXPECT_TRUE(setOf(document, 1) ==
                        segment::subtract(meant(5.02, isDisc, range), meant(2.01, isDisc, {})));
            document.apply(Undo{});
            document.apply(Undo{});
            EXPECT_TRUE(stateOf(document) == before);
        }
    }
}

TEST_F(PaintingTest, ThinBrushesLeaveNoGaps) {
    Document document(testHead());
    document.apply(PaintSegment{true, {{{10, 10, 10}, {40, 25, 30}}, 0}});
    EXPECT_EQ(document.segments().segments.size(), 1U);
    document.apply(editOf(EditSegment::Kind::KeepLargest));
    const VoxelSet line = setOf(document, 1);
    EXPECT_GE(line.count(), 31U); // the longest way along an axis
    EXPECT_TRUE(line.contains({10, 10, 10}));
    EXPECT_TRUE(line.contains({40, 25, 30}));
    const auto before = stateOf(document);
    document.apply(PaintSegment{true, {{{-50, -50, -50}}, 3}});
    EXPECT_TRUE(stateOf(document) == before);
    document.apply(UseSegment{"Segment 1", {}, {}, {}, {}, true});
    EXPECT_NE(test::refusal(document, PaintSegment{true, {{{10, 10, 10}}, 3}}).find("is locked"),
              std::string::npos);
}

TEST_F(PaintingTest, SeedsUnderTrailsAreTheVoxelsInRange) {
    Document document(testHead());
    Seed seed;
    seed.trails = {{{{30, 18, 30}, {40, 18, 30}}, 3, 2}};
    seed.range = Range{80, 120};
    document.apply(seed);
    const VoxelSet found = setOf(document, 1);
    EXPECT_TRUE(found == segment::intersect(voxelsAlong(seed.trails.front(), document.volume().geometry),
                                            inRange(document, {80, 120})));
    EXPECT_GT(found.count(), 10U);
    const auto& logged = std::get<Seed>(document.log().back());
    EXPECT_EQ(logged.voxels.size(), found.count());
    EXPECT_EQ(logged.trails, seed.trails);
}

} // namespace
} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "field/field.h"
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_head.h"
#include "studio/document/live_stroke.h"
#include "studio/strokes/cut_stroke.h"

namespace vs::studio {
namespace {

using CutCostTest = test::GlTest;

// A ball of radius 20 in the middle of a cube.
volume::Volume ballIn(int side) {
    return phantom::makePhantom(glm::ivec3(side), volume::ScalarType::UInt8, [&](glm::dvec3 p) {
        return 200 * std::clamp((20 - glm::distance(p, glm::dvec3(0.5 * (side - 1)))) / 4 + 0.5, 0.0, 1.0);
    });
}

// What the same stamp of a drill, and the stroke after it, did in voxels, bytes and points.
struct Work {
    std::size_t changed = 0;
    std::size_t bricks = 0;
    std::size_t copied = 0;
    std::size_t cleared = 0;
};

Work stampIn(int side) {
    const auto volume = ballIn(side);
    const auto field = field::uploadVolume(volume);
    sculpt::Sculpture sculpture(volume.geometry.dims);
    Cutter cutter(field, sculpture);
    const glm::dvec3 middle(0.5 * (side - 1));
    const auto mask = sculpt::rasterize(sculpt::circleOutline({0, 0}, 8), 0.5);
    std::vector<field::SurfacePoint> surface(mask.values.size());
    for (std::size_t n = 0; n < surface.size(); ++n) {
        const auto width = std::size_t(mask.size.x);
        const glm::dvec2 off = mask.origin + mask.pitch * glm::dvec2(n % width, n / width);
        surface[n].voxel = glm::vec4(glm::vec3(middle + glm::dvec3(off, -18)), 1);
        surface[n].normal = glm::vec4(0, 0, -1, 0);
    }
    sculpt::BrickBackup backup(sculpture.texels());
    sculpt::ToolCut cut;
    cutter.tools.cut(sculpture, surface, mask, cut, &backup);
    const auto delta = backup.finish();
    cutter.snapshot();
    Work work{delta.changedVoxels(), delta.bricks().size(), cutter.copiedVoxels(),
              sculpture.touchedBricks().size()};
    cutter.snapshot();
    EXPECT_EQ(cutter.copiedVoxels(), 0U) << "nothing has changed since";
    return work;
}

TEST_F(CutCostTest, TheSameStampDoesTheSameWorkInEveryVolume) {
    const Work small = stampIn(64);
    // A multiple of a brick more on each side: the stamp lies the same among tiles and bricks.
    const Work large = stampIn(192);
    EXPECT_GT(small.changed, 2000U);
    EXPECT_EQ(large.changed, small.changed);
    EXPECT_EQ(large.bricks, small.bricks);
    EXPECT_EQ(large.copied, small.copied);
    EXPECT_LT(large.copied, 40U * 40 * 40);
    EXPECT_EQ(large.cleared, small.cleared);
}

TEST_F(CutCostTest, ASnapshotIsTheSculptureWhateverHappenedSince) {
    // Peels see the snapshot of what was cut before: undo, redo, un-cut and discarded strokes in between.
    const auto peeled = [](const std::vector<Operation>& operations) {
        Document fresh(test::testHead());
        for (const Operation& operation : operations) {
            fresh.apply(operation);
        }
        fresh.stroke().begin(Peel{test::somePeel().mask, 0, 3, false, test::testCanvas()});
        fresh.stroke().peelTo(9);
        fresh.stroke().peelTo(4);
        fresh.stroke().commit();
        return test::sculptureBytes(fresh);
    };
    Drill drill;
    drill.mask = test::ellipseAt(210, 120, 14, 14);
    drill.canvas = test::testCanvas();
    Drill other = drill;
    other.mask = test::ellipseAt(180, 100, 10, 10);
    const auto wanted = peeled({drill});
    EXPECT_EQ(peeled({drill, other, Undo{}}), wanted);
    EXPECT_EQ(peeled({other, Undo{}, drill}), wanted);
    EXPECT_EQ(peeled({other, UnCut{}, drill}), wanted);
    EXPECT_EQ(peeled({test::somePeel(3), Undo{}, drill, Undo{}, Redo{}}), wanted);
}

} // namespace
} // namespace vs::studio

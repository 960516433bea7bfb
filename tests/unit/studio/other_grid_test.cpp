// SPDX-License-Identifier: Apache-2.0
// Operations as they are on another level of a store.
#include "studio/operations/other_grid.h"

#include <gtest/gtest.h>

namespace vs::studio {
namespace {

volume::GridGeometry levelOf(int factor) {
    volume::GridGeometry grid = volume::makeGeometry(glm::ivec3(64) / factor, glm::dvec3(0.5 * factor));
    grid.worldFromVoxel[3] = glm::dvec4(glm::dvec3(10, 20, 30) + 0.25 * (factor - 1), 1); // its first corner
    return grid;
}

const OtherGrid kCoarser = otherGrid(levelOf(1), levelOf(4));
const OtherGrid kFiner = otherGrid(levelOf(4), levelOf(1));

template <typename Op>
Op converted(const Op& op, const OtherGrid& grid) {
    return std::get<Op>(onGrid(op, grid));
}

TEST(OtherGridTest, KnowsWhereVoxelsLie) {
    EXPECT_DOUBLE_EQ(kCoarser.scale.x, 0.25);
    EXPECT_DOUBLE_EQ(kCoarser.offset.y, -0.375);
    EXPECT_DOUBLE_EQ(kCoarser.steps, 0.25);
    volume::GridGeometry turned = levelOf(4);
    std::swap(turned.worldFromVoxel[0], turned.worldFromVoxel[1]);
    EXPECT_ANY_THROW(static_cast<void>(otherGrid(levelOf(1), turned)));
}

TEST(OtherGridTest, PlacesAndDepthsStayWhereTheyAre) {
    Drill drill;
    drill.depthMax = 12;
    drill.mask = {Shape::Circle, {{100, 100}, {120, 100}}};
    drill.stroke = {{{100, 100}, 0.5}};
    drill.canvas = Canvas{};
    drill.canvas->view.surfaceSmoothing = 2;
    const Drill coarse = converted(drill, kCoarser);
    EXPECT_DOUBLE_EQ(coarse.depthMax, 3);
    EXPECT_EQ(coarse.radius, drill.radius); // voxels of what is cut
    EXPECT_EQ(coarse.mask, drill.mask);     // pixels
    EXPECT_DOUBLE_EQ(coarse.stroke.front().pressure, 0.5);
    EXPECT_DOUBLE_EQ(coarse.canvas->view.surfaceSmoothing, 0.5);
    EXPECT_DOUBLE_EQ(converted(coarse, kFiner).depthMax, 12);

    Clip clip;
    clip.box = Clip::Box{{-0.5, 3.5, 7.5}, {63.5, 60, 50}};
    clip.planes = {{{1, 2, 3}, {0, 0, 1}}};
    const Clip cut = converted(clip, kCoarser);
    EXPECT_DOUBLE_EQ(cut.box->lo.x, -0.5); // the grid's border on both
    EXPECT_DOUBLE_EQ(cut.box->lo.y, 0.5);
    EXPECT_DOUBLE_EQ(cut.box->hi.x, 15.5);
    EXPECT_EQ(cut.planes, clip.planes); // millimetres

    BrushSegment brush;
    brush.stroke = drill;
    EXPECT_DOUBLE_EQ(std::get<Drill>(converted(brush, kCoarser).stroke).depthMax, 3);
}

TEST(OtherGridTest, SweepsKeepTheirShapeAndTheirSampling) {
    Sweep sweep;
    sweep.mask = {Shape::Circle, {{0, 0}, {8, 0}}};
    sweep.path.kind = SweepPath::Kind::Helix;
    sweep.path.points = {{0, 0, 0}, {0, 0, 60}};
    sweep.path.helixRadius = 10;
    const Sweep coarse = converted(sweep, kCoarser);
    EXPECT_DOUBLE_EQ(coarse.mask.points[1].x, 2);
    EXPECT_DOUBLE_EQ(coarse.path.helixRadius, 2.5);
    EXPECT_DOUBLE_EQ(coarse.path.points[1].z, 60 * 0.25 - 0.375);
    EXPECT_DOUBLE_EQ(coarse.pitch, sweep.pitch);
    sweep.path = {};
    sweep.path.kind = SweepPath::Kind::Surface;
    sweep.path.stroke = {{10, 10}, {20, 20}};
    EXPECT_EQ(converted(sweep, kCoarser).mask, sweep.mask); // pixels
}

TEST(OtherGridTest, GrowthGoesAsFar) {
    Grow grow;
    grow.generations = 30;
    EXPECT_EQ(converted(grow, kCoarser).generations, 8);
    EXPECT_EQ(converted(Grow{}, kCoarser).generations, std::nullopt);
    EXPECT_EQ(converted(Rewind{8}, kFiner).generations, 32);
    Seed seed;
    seed.voxels = {{40, 41, 2}, {0, 0, 0}};
    EXPECT_EQ(converted(seed, kCoarser).voxels, (std::vector<glm::ivec3>{{10, 10, 0}, {0, 0, 0}}));
    seed.strokes = {{Shape::FreeForm, {{1, 1}, {2, 2}}}};
    EXPECT_TRUE(converted(seed, kCoarser).voxels.empty()); // looked for again
    CorrectGeometry correct;
    correct.spacing = glm::dvec3(0.5, 0.5, 0.75);
    EXPECT_DOUBLE_EQ(converted(correct, kCoarser).spacing->z, 3);
}

TEST(OtherGridTest, AFinestVoxelIsKnownWhereverItCanBe) {
    KeepConnected keep;
    keep.finest = glm::ivec3(21, 30, 63);
    const auto told = [](const Operation& op, const OtherGrid& grid) {
        return std::get<KeepConnected>(withoutFinest(op, grid));
    };
    EXPECT_TRUE(namesFinest(keep));
    EXPECT_EQ(told(keep, kCoarser).voxel, glm::ivec3(5, 7, 15)); // the voxel that it lies in
    EXPECT_EQ(told(keep, {}).voxel, keep.finest);
    keep.canvas = Canvas{};
    keep.pixel = {12, 13};
    EXPECT_FALSE(told(keep, kCoarser).voxel); // it is looked for under the pixel
    EXPECT_EQ(told(keep, {}).voxel, keep.finest);
    EXPECT_FALSE(namesFinest(told(keep, {})));
    // Made on the finest level, and replayed where tools work on that beside a coarser one; and back.
    KeepConnected made;
    made.voxel = glm::ivec3(21, 30, 63);
    OtherGrid toCoarser = kCoarser;
    toCoarser.isFromFinest = true;
    EXPECT_EQ(converted(made, toCoarser).finest, made.voxel);
    OtherGrid toFinest = kFiner;
    toFinest.isToFinest = true;
    EXPECT_EQ(converted(converted(made, toCoarser), toFinest).voxel, made.voxel);
}

} // namespace
} // namespace vs::studio

// SPDX-License-Identifier: Apache-2.0
#include "tool_fixture.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {
namespace {

using DrillTest = test::GlTest;
using test::drill;
using test::Workpiece;

const glm::ivec3 kDims(72, 68, 48);
const MaskRaster kDisc = rasterize(circleOutline({36, 34}, 14), 0.5);

TEST_F(DrillTest, FloorOfASlabLiesAtTheAskedDepth) {
    for (const double depth : {0.5, 1.0, 3.3, 8.0, 10.0}) {
        for (const int radius : {2, 3, 4}) {
            Workpiece piece(kDims);
            auto how = drill(depth);
            how.sweep.radius = radius;
            piece.cut(test::slabUnder(kDisc, 15.3), kDisc, how);
            const auto values = piece.values();
            for (const glm::dvec2 at : {glm::dvec2(36, 34), glm::dvec2(31.4, 36.2), glm::dvec2(40, 30)}) {
                EXPECT_NEAR(test::crossingOf(values, kDims, {at, 14.5}, {0, 0, 1}, 30) - 0.8, depth, 0.15)
                    << depth << " " << radius;
            }
            // The first layer goes, and so does a little before the surface.
            EXPECT_GT(test::sampleGrid(values, kDims, {36, 34, 15.3}), 0.6F);
            EXPECT_GT(test::sampleGrid(values, kDims, {36, 34, 14.0}), 0.5F);
        }
    }
}

TEST_F(DrillTest, WallsLieOnTheDrawnOutline) {
    Workpiece piece(kDims);
    piece.cut(test::slabUnder(kDisc, 15.3), kDisc, drill(12));
    const auto values = piece.values();
    double squared = 0;
    for (int n = 0; n < 48; ++n) {
        const double angle = 0.13 * n;
        const glm::dvec3 way(std::cos(angle), std::sin(angle), 0);
        const double off = test::crossingOf(values, kDims, {36, 34, 21.7}, way, 20) - 14;
        squared += off * off / 48;
    }
    EXPECT_LT(std::sqrt(squared), 0.1);
}

TEST_F(DrillTest, NothingToDoChangesNothing) {
    Workpiece piece(kDims);
    const auto surface = test::slabUnder(kDisc, 15.3);
    const std::vector<field::SurfacePoint> misses(surface.size());
    MaskRaster empty = kDisc;
    std::fill(empty.values.begin(), empty.values.end(), 0.0F);
    EXPECT_TRUE(piece.cut(surface, kDisc, drill(0)).isEmpty());
    EXPECT_TRUE(piece.cut(misses, kDisc, drill(10)).isEmpty());
    EXPECT_TRUE(piece.cut(surface, empty, drill(10)).isEmpty());
    EXPECT_TRUE(piece.cut({}, rasterize({}, 0.5), drill(10)).isEmpty());
    EXPECT_TRUE(piece.sculpture.isEmpty());
    EXPECT_EQ(piece.sculpture.version(), 0U);
    const auto values = piece.values();
    EXPECT_EQ(*std::max_element(values.begin(), values.end()), 0.0F);
}

TEST_F(DrillTest, TheSameStrokeTwiceEqualsOnce) {
    Workpiece piece(kDims);
    const auto surface = test::slabUnder(kDisc, 15.3);
    piece.cut(surface, kDisc, drill(9));
    EXPECT_GT(piece.sculpture.changedVoxels(), 5000U);
    const auto once = piece.bytes();
    piece.cut(surface, kDisc, drill(9));
    EXPECT_EQ(piece.sculpture.changedVoxels(), 0U);
    EXPECT_EQ(piece.bytes(), once);
}

TEST_F(DrillTest, RestoringTheSameStrokeLeavesNothingVisible) {
    Workpiece piece(kDims);
    const auto surface = test::slabUnder(kDisc, 15.3);
    auto how = drill(9);
    piece.cut(surface, kDisc, how);
    how.how = Combine::Restore;
    piece.cut(surface, kDisc, how);
    const auto values = piece.values();
    EXPECT_LT(*std::max_element(values.begin(), values.end()), 0.5F);
    EXPECT_LT(test::sampleGrid(values, kDims, {36, 34, 19}), 0.01F);
}

TEST_F(DrillTest, DisjointStrokesCommute) {
    const auto left = rasterize(circleOutline({20, 34}, 8), 0.5);
    const auto right = rasterize(circleOutline({50, 34}, 8), 0.5);
    Workpiece a(kDims);
    a.cut(test::slabUnder(left, 15.3), left, drill(9));
    a.cut(test::slabUnder(right, 12.1), right, drill(6));
    Workpiece b(kDims);
    b.cut(test::slabUnder(right, 12.1), right, drill(6));
    b.cut(test::slabUnder(left, 15.3), left, drill(9));
    EXPECT_EQ(a.bytes(), b.bytes());
}

TEST_F(DrillTest, OverlappingStampsUniteAndDoNotAdd) {
    Workpiece piece(kDims);
    for (int n = 0; n < 6; ++n) {
        const auto stamp = rasterize(circleOutline({30 + n, 34}, 10), 0.5);
        piece.cut(test::slabUnder(stamp, 15.3), stamp, drill(7));
    }
    const auto values = piece.values();
    for (int x = 28; x <= 38; x += 2) {
        EXPECT_NEAR(test::crossingOf(values, kDims, {x, 34, 14.3}, {0, 0, 1}, 20) - 1, 7, 0.15);
    }
    EXPECT_LE(*std::max_element(values.begin(), values.end()), 1.0F);
}

// The same circle in rasters of different density gives the same cut.
TEST_F(DrillTest, TheMasksDensityDoesNotMatter) {
    std::vector<std::vector<float>> results;
    for (const double pitch : {0.5, 0.25, 0.1}) {
        const auto mask = rasterize(circleOutline({36, 34}, 14), pitch);
        Workpiece piece(kDims);
        piece.cut(test::slabUnder(mask, 15.3), mask, drill(9.4));
        results.push_back(piece.values());
    }
    EXPECT_LE(test::largestDifference(results[0], results[1]), 0.02F);
    EXPECT_LE(test::largestDifference(results[1], results[2]), 0.02F);
}

TEST_F(DrillTest, ACoarseMaskLeavesNoHoles) {
    // Zoomed out: three voxels from element to element.
    const auto mask = rasterize(circleOutline({36, 34}, 20), 3);
    Workpiece piece(kDims);
    piece.cut(test::slabUnder(mask, 15.3), mask, drill(9));
    const auto values = piece.values();
    for (int y = 24; y < 44; ++y) {
        for (int x = 26; x < 46; ++x) {
            EXPECT_NEAR(test::sampleGrid(values, kDims, {x, y, 19}), 1, 0.01) << x << " " << y;
        }
    }
}

TEST_F(DrillTest, ASteepSurfaceIsCutToItsDepthEverywhere) {
    // A plane leaning 70 degrees, drilled along z: neighbouring rays end 1.4 voxels apart along z.
    const auto mask = rasterize(rectangleOutline({28, 24}, {44, 44}), 0.5);
    const double slope = std::tan(1.2217);
    const auto height = [&](double x) { return 24 + slope * (x - 36) * 0.5; };
    const auto surface = test::surfaceUnder(mask, [&](glm::dvec2 e) {
        return test::SurfaceHit{{e.x, e.y, height(e.x)}, {0, 0, -1}};
    });
    Workpiece piece({72, 68, 64});
    piece.cut(surface, mask, drill(10));
    const auto values = piece.values();
    for (double x = 32; x <= 40; x += 0.7) {
        const double found =
            test::crossingOf(values, piece.dims(), {x, 34, height(x) + 3}, {0, 0, 1}, 20) + 3;
        EXPECT_NEAR(found, 10, 0.15) << x;
    }
}

TEST_F(DrillTest, SilhouettesAreNotJoined) {
    // A step of 20 voxels at x = 36: the columns of both sides end where they should, and no wall is cut
    // between them.
    const auto surface = test::surfaceUnder(kDisc, [&](glm::dvec2 e) {
        return test::SurfaceHit{{e.x, e.y, e.x < 36 ? 8 : 30}, {0, 0, -1}};
    });
    Workpiece piece(kDims);
    piece.cut(surface, kDisc, drill(6));
    const auto values = piece.values();
    EXPECT_NEAR(test::crossingOf(values, kDims, {30, 34, 8}, {0, 0, 1}, 15), 6, 0.15);
    EXPECT_NEAR(test::crossingOf(values, kDims, {42, 34, 30}, {0, 0, 1}, 15), 6, 0.15);
    for (const double x : {35.0, 36.0, 37.0}) {
        EXPECT_LT(test::sampleGrid(values, kDims, {x, 34, 22}), 0.01F) << x;
    }
    // Behind, the cut ends at the step; in front it goes on beyond it by the radius, where nothing is seen,
    // so that the piece's edge goes too.
    EXPECT_NEAR(test::crossingOf(values, kDims, {42, 34, 32}, {-1, 0, 0}, 12), 6, 0.3);
    const double front = test::crossingOf(values, kDims, {30, 34, 10}, {1, 0, 0}, 12);
    EXPECT_GT(front, 6 + 2);
    EXPECT_LT(front, 6 + 3.5);
}

TEST_F(DrillTest, ThinMasksCutAllTheSame) {
    // A tenth of a voxel wide: without more energy its radiation would stay near 0.04.
    const auto line = rasterize(rectangleOutline({26, 33.95}, {46, 34.05}), 0.1);
    Workpiece piece(kDims);
    piece.cut(test::slabUnder(line, 15.3), line, drill(8));
    EXPECT_GE(test::sampleGrid(piece.values(), kDims, {36, 34, 19}), 0.5F);
    EXPECT_LT(test::sampleGrid(piece.values(), kDims, {36, 37, 19}), 0.1F);
}

TEST_F(DrillTest, DepthCountsStepsOnAnisotropicGrids) {
    const glm::ivec3 dims(72, 68, 24);
    const auto mask = rasterize(circleOutline({36, 34}, 14), 0.5);
    Workpiece piece(dims, {0.8, 0.8, 2.0});
    piece.cut(test::slabUnder(mask, 6), mask, drill(10)); // 8 mm are 4 slices
    EXPECT_NEAR(test::crossingOf(piece.values(), dims, {36, 34, 6}, {0, 0, 1}, 10), 4, 0.15);
}

TEST_F(DrillTest, AtTheGridsBorderOnlyTheInsideIsCut) {
    const auto mask = rasterize(circleOutline({2, 3}, 9), 0.5);
    Workpiece piece({24, 24, 24});
    const Box3 box = piece.cut(test::slabUnder(mask, -0.5), mask, drill(6));
    EXPECT_EQ(box.lo, glm::ivec3(0));
    EXPECT_NEAR(test::crossingOf(piece.values(), {24, 24, 24}, {2, 3, 0}, {0, 0, 1}, 15), 5.5, 0.15);
    EXPECT_GT(test::sampleGrid(piece.values(), {24, 24, 24}, {0, 0, 0}), 0.99F);
}

TEST_F(DrillTest, SurfacePointsOnTheDeviceDoTheSame) {
    const auto surface = test::slabUnder(kDisc, 15.3);
    Workpiece a(kDims);
    a.cut(surface, kDisc, drill(9));
    field::SurfacePoints onDevice{gl::Buffer(surface.size() * sizeof(field::SurfacePoint), "points"),
                                  kDisc.size};
    onDevice.points.write(std::span(surface));
    Workpiece b(kDims);
    b.cutter.cut(b.sculpture, onDevice, kDisc, drill(9), nullptr);
    EXPECT_EQ(a.bytes(), b.bytes());
}

} // namespace
} // namespace vs::sculpt

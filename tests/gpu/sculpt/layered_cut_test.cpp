// SPDX-License-Identifier: Apache-2.0
#include "property.h"
#include "sculpt/surface/layered_cut.h"
#include "tool_fixture.h"

#include <algorithm>

namespace vs::sculpt {
namespace {

using LayeredCutTest = test::GlTest;
using test::Workpiece;
using Bytes = std::vector<std::byte>;

const glm::ivec3 kLayeredDims(90, 84, 70);
const glm::dvec3 kCentre(45, 42, 62);
const MaskRaster kMask = rasterize(ellipseOutline({43, 42}, {20, 14}), 0.5);

// A workpiece, perhaps with a cut in it, and a peel of it under way.
struct Peeling {
    explicit Peeling(bool isCutBefore, double radius = 55, const MaskRaster& mask = kMask)
        : piece(kLayeredDims) {
        if (isCutBefore) {
            const auto hole = rasterize(circleOutline({52, 40}, 9), 0.5);
            piece.cut(test::slabUnder(hole, 10), hole, test::drill(14));
        }
        earlier =
            gl::Texture(kLayeredDims, piece.sculpture.texels().format(), gl::Filter::Nearest, "earlier");
        earlier.copyFrom(piece.sculpture.texels(), piece.geometry.box(), glm::ivec3(0));
        untouched = piece.bytes();
        peel.emplace(test::sphereUnder(mask, kCentre, radius), mask, test::peel(1).sweep, piece.geometry,
                     isCutBefore ? &earlier : nullptr);
    }
    void to(double depth, BrickBackup* backup = nullptr) {
        peel->cutTo(depth, piece.cutter.radiator(), piece.cutter.generator(), piece.sculpture, backup);
    }
    // The cells are those of the content, as if they were all made anew.
    bool areCellsRight() {
        const auto kept = piece.sculpture.cells().downloadAll<glm::vec2>();
        piece.sculpture.refresh(piece.geometry.box());
        return kept == piece.sculpture.cells().downloadAll<glm::vec2>();
    }

    Workpiece piece;
    gl::Texture earlier;
    Bytes untouched;
    std::optional<LayeredCut> peel;
};

Bytes atOnce(double depth, bool isCutBefore) {
    Peeling peeling(isCutBefore);
    peeling.to(depth);
    return peeling.piece.bytes();
}

TEST_F(LayeredCutTest, WhateverTheWayADepthIsTheSameToTheLastByte) {
    for (const bool isCutBefore : {false, true}) {
        Peeling peeling(isCutBefore);
        // Down, back, beyond the room of the beginning (24 steps, then 81) and up again.
        for (const double depth : {0.1, 0.7, 3.0, 2.4, 2.4, 7.9, 12.2, 40.5, 41.0, 39.0, 20.0, 5.3, 0.2}) {
            peeling.to(depth);
            ASSERT_TRUE(peeling.piece.bytes() == atOnce(depth, isCutBefore)) << depth << " " << isCutBefore;
        }
        EXPECT_TRUE(peeling.areCellsRight());
        peeling.to(0);
        EXPECT_TRUE(peeling.piece.bytes() == peeling.untouched);
        peeling.to(6);
        EXPECT_TRUE(peeling.piece.bytes() == atOnce(6, isCutBefore));
    }
}

TEST_F(LayeredCutTest, RandomWaysEndTheSame) {
    const Bytes expected = atOnce(4.7, true);
    test::checkProperty(3, [&expected] {
        Peeling peeling(true);
        for (const int tenths : *test::upTo(30, test::below(150))) {
            peeling.to(0.1 * tenths);
        }
        peeling.to(4.7);
        RC_ASSERT((peeling.piece.bytes() == expected));
        RC_ASSERT(peeling.areCellsRight());
    });
}

TEST_F(LayeredCutTest, LayersAddUpToTheWholeSweep) {
    for (const double depth : {0.4, 1.0, 6.0, 11.5, 36.7}) {
        Peeling peeling(true);
        peeling.to(depth);
        Peeling whole(true);
        whole.piece.cut(test::sphereUnder(kMask, kCentre, 55), kMask, test::peel(depth));
        // Samples lie elsewhere: that much is the lattice's ripple.
        EXPECT_LE(test::largestDifference(peeling.piece.values(), whole.piece.values()), 0.06F) << depth;
    }
}

TEST_F(LayeredCutTest, ABackupTakesItAllBack) {
    Peeling peeling(true);
    BrickBackup backup(peeling.piece.sculpture.texels());
    for (const double depth : {3.0, 9.5, 4.0, 30.0, 6.2}) {
        peeling.to(depth, &backup);
    }
    const Bytes peeled = peeling.piece.bytes();
    BrickDelta delta = backup.finish();
    peeling.piece.sculpture.swap(delta);
    EXPECT_TRUE(peeling.piece.bytes() == peeling.untouched);
    peeling.piece.sculpture.swap(delta);
    EXPECT_TRUE(peeling.piece.bytes() == peeled);
}

TEST_F(LayeredCutTest, AChangeOfDepthMovesOnlyWhatLiesBetween) {
    Peeling peeling(false);
    peeling.to(7);
    const std::size_t all = peeling.peel->pointsMoved();
    peeling.to(7.5);
    const std::size_t half = peeling.peel->pointsMoved();
    EXPECT_GT(half, 0U);
    EXPECT_LT(half, all / 8);
    peeling.to(7.6); // a part back, a part anew
    EXPECT_LE(peeling.peel->pointsMoved(), 2 * half);
    peeling.to(7.6);
    EXPECT_EQ(peeling.peel->pointsMoved(), 0U);
}

TEST_F(LayeredCutTest, AnyDepthIsAsGoodAsInfinite) {
    // From a ball of radius 20 all paths have met long before 4000 steps.
    const auto mask = rasterize(circleOutline({45, 42}, 12), 0.5);
    Peeling deep(false, 20, mask);
    deep.to(400);
    const auto values = deep.piece.values();
    deep.to(4000);
    EXPECT_LE(test::largestDifference(values, deep.piece.values()), 0.02F);
    Peeling again(false, 20, mask);
    again.to(4000);
    EXPECT_TRUE(again.piece.bytes() == deep.piece.bytes());
}

TEST_F(LayeredCutTest, WithoutASurfaceNothingHappens) {
    Workpiece piece(kLayeredDims);
    const std::vector<field::SurfacePoint> misses(kMask.values.size());
    LayeredCut peel(misses, kMask, test::peel(1).sweep, piece.geometry, nullptr);
    for (const double depth : {3.0, 1.0, 50.0, 0.0}) {
        EXPECT_TRUE(
            peel.cutTo(depth, piece.cutter.radiator(), piece.cutter.generator(), piece.sculpture, nullptr)
                .isEmpty());
    }
    EXPECT_TRUE(piece.sculpture.isEmpty());
}

} // namespace
} // namespace vs::sculpt

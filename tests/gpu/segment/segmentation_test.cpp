// SPDX-License-Identifier: Apache-2.0
#include "field/cell_ranges.h"
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "segment/growth/growth_undo.h"
#include "segment/membership/membership.h"
#include "segment/membership/segmentation.h"

#include <cmath>
#include <limits>

namespace vs::segment {
namespace {

using SegmentationTest = test::GlTest;

void expectTruth(const Growth& growth, const Segmentation& segmentation, const std::string& what) {
    const auto labels = growth.labels();
    const auto texels = texelsOf(segmentation);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        wrong += (texels[i] >= 128) != (labels[i] == 1) ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0U) << what;
}

// Texels and cells as a segmentation made afresh has them.
void expectEqualsFresh(const Growth& growth, const Segmentation& segmentation, const std::string& what) {
    Segmentation fresh(growth.field().geometry);
    fresh.update(growth);
    EXPECT_TRUE(texelsOf(segmentation) == texelsOf(fresh)) << what;
    gl::Texture cells(segmentation.cells().size(), gl::Format::RG32F, gl::Filter::Nearest, "expected cells");
    field::CellRangeUpdater().update(segmentation.texels(), growth.field().geometry.box(), cells);
    EXPECT_TRUE(segmentation.cells().downloadAll<float>() == cells.downloadAll<float>()) << what;
}

TEST_F(SegmentationTest, IsTheGaussianHeldToTheTruth) {
    // Anisotropic, so that the kernel is narrower along z.
    const glm::ivec3 dims(37, 21, 19);
    const glm::dvec3 spacing(1, 1, 2.5);
    std::mt19937 random(3);
    const auto volume = phantom::makePhantom(
        dims, volume::ScalarType::UInt8, [&](glm::dvec3) { return double(random() % 100); }, spacing);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
    Constraints constraints;
    constraints.range = {0, 55};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{18, 10, 9}, {1, 1, 1}, {30, 15, 3}, {36, 20, 18}, {17, 10, 9}});
    growth.advance(kAll);
    Segmentation segmentation(volume.geometry);
    segmentation.update(growth);

    const auto labels = growth.labels();
    const auto texels = texelsOf(segmentation);
    const auto member = [&](glm::ivec3 v) {
        const bool inside =
            glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, dims));
        return inside && labels[(std::size_t(v.z) * dims.y + v.y) * dims.x + v.x] == 1 ? 1.0 : 0.0;
    };
    double weights[3][7];
    for (int axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (int i = -3; i <= 3; ++i) {
            weights[axis][i + 3] = std::exp(-0.5 * i * i * spacing[axis] * spacing[axis]);
            sum += weights[axis][i + 3];
        }
        for (double& w : weights[axis]) {
            w /= sum;
        }
    }
    const Membership membership(labels, volume.geometry, 1); // the same on the CPU, of one segment
    double worst = 0;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                double value = 0;
                for (int n = 0; n < 343; ++n) {
                    const glm::ivec3 o(n % 7, n / 7 % 7, n / 49);
                    value += weights[0][o.x] * weights[1][o.y] * weights[2][o.z] *
                             member(glm::ivec3(x, y, z) + o - 3);
                }
                value *= 255;
                value = member({x, y, z}) > 0 ? std::max(value, 255 - value) : std::min(value, 255 - value);
                const int texel = texels[(std::size_t(z) * dims.y + y) * dims.x + x];
                worst = std::max(
                    {worst, std::abs(value - texel), std::abs(255 * membership.at({x, y, z}) - texel)});
            }
        }
    }
    EXPECT_LT(worst, 0.6) << "half a texel's unit of rounding, and single precision";
    expectTruth(growth, segmentation, "anisotropic");
}

TEST_F(SegmentationTest, IncrementalUpdatesEqualFreshOnesByteForByte) {
    const auto volume = randomVolume({70, 50, 41}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
    Segmentation segmentation(volume.geometry);
    Constraints constraints;
    constraints.range = {0, 60};
    growth.setConstraints(constraints);
    EXPECT_TRUE(segmentation.update(growth).isEmpty());
    EXPECT_EQ(segmentation.version(), 0U);
    growth.addSeeds(std::vector<glm::ivec3>{{15, 15, 15}, {16, 16, 16}, {40, 20, 33}, {0, 0, 0}});
    const auto check = [&](const std::string& what) {
        segmentation.update(growth);
        expectTruth(growth, segmentation, what);
        expectEqualsFresh(growth, segmentation, what);
    };
    check("seeds");
    growth.advance(5);
    check("forward");
    growth.advance(12);
    check("further");
    growth.takeBack(9);
    check("back");
    const auto version = segmentation.version();
    EXPECT_TRUE(segmentation.update(growth).isEmpty());
    EXPECT_EQ(segmentation.version(), version) << "nothing changed";
    GrowthUndo undo;
    constraints.range = {0, 80};
    growth.setConstraints(constraints, &undo);
    check("other rules show the same");
    undo.undo(growth);
    growth.addSeeds(std::vector<glm::ivec3>{{60, 40, 5}, {61, 40, 5}, {60, 41, 5}}, &undo);
    check("late seeds");
    undo.undo(growth);
    check("seeds undone");
    growth.advance(kAll, &undo);
    check("to the end");
    undo.undo(growth);
    check("undone");
    growth.reset();
    check("erased");
    for (const auto texel : texelsOf(segmentation)) {
        ASSERT_EQ(texel, 0);
    }
}

TEST_F(SegmentationTest, ASingleVoxelReachesTheTilesAround) {
    // Along a diagonal, so that each border of a 16^3 tile is met at every distance, on all axes at once.
    const auto volume =
        phantom::makePhantom({40, 40, 40}, volume::ScalarType::UInt8, [](glm::dvec3) { return 10.0; });
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
    Constraints constraints;
    constraints.range = {10, 10};
    growth.setConstraints(constraints);
    Segmentation segmentation(volume.geometry);
    for (int i = 10; i < 23; ++i) {
        growth.reset();
        segmentation.update(growth);
        const glm::ivec3 seed(i, i, 33 - i);
        growth.addSeeds(std::span(&seed, 1));
        segmentation.update(growth);
        expectEqualsFresh(growth, segmentation, fmt::format("one voxel at {}", i));
        const auto texels = texelsOf(segmentation);
        for (int n = 0; n < 6; ++n) {
            glm::ivec3 v = seed;
            v[n / 2] += n % 2 == 0 ? 2 : -2; // farther off, less than a texel's unit is left
            EXPECT_GT(texels[(std::size_t(v.z) * 40 + v.y) * 40 + v.x], 0) << i << " " << n;
        }
    }
}

TEST_F(SegmentationTest, SixBytesAVoxelAreEnough) {
    // A head, which fills its last bricks badly, and a cube, whose scratch memory counts for more.
    for (const glm::ivec3 dims : {glm::ivec3(181, 217, 181), glm::ivec3(256)}) {
        const auto volume =
            phantom::makePhantom(dims, volume::ScalarType::UInt8, [](glm::dvec3) { return 10.0; });
        const field::Field field = field::uploadVolume(volume);
        Growth growth(field);
        Constraints constraints;
        constraints.range = {10, 10};
        growth.setConstraints(constraints);
        growth.addSeeds(std::vector<glm::ivec3>{{90, 90, 90}});
        growth.advance(20);
        Segmentation segmentation(volume.geometry);
        segmentation.update(growth);
        // Scratch of a size of its own is no matter of the volume's.
        constexpr double kScratchBytes = 13 << 20;
        const double bytes = double(growth.deviceBytes() + segmentation.deviceBytes()) - kScratchBytes;
        const double perVoxel = bytes / double(volume.geometry.voxelCount());
        EXPECT_LT(perVoxel, 6.0) << dims.x;
        RecordProperty("bytesPerVoxel", std::to_string(perVoxel));
    }
}

TEST_F(SegmentationTest, HurriedUpdatesArriveAtTheSame) {
    const auto volume = randomVolume({90, 80, 70}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
    Segmentation segmentation(volume.geometry);
    Constraints constraints;
    constraints.range = {0, 60};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{15, 15, 15}, {16, 16, 16}, {40, 20, 33}});
    const double barely = 1e-6; // for the first tiles
    const auto hurry = [&](double budgetMs, Smoothing smoothing = Smoothing::Smooth) {
        segmentation.update(growth, smoothing, allOpaque(), budgetMs);
        return segmentation.isBehind();
    };
    EXPECT_FALSE(hurry(1e6));
    const auto before = texelsOf(segmentation);
    growth.advance(30);
    EXPECT_TRUE(hurry(0)) << "no time at all";
    EXPECT_TRUE(texelsOf(segmentation) == before);
    EXPECT_TRUE(hurry(barely));
    growth.advance(10); // it goes on meanwhile
    EXPECT_FALSE(hurry(barely, Smoothing::Plain)) << "nothing waits in a plain picture";
    expectTruth(growth, segmentation, "plain, with a queue");
    growth.takeBack(3);
    int updates = 0;
    while (hurry(5) && updates < 1000) {
        ++updates;
    }
    EXPECT_LT(updates, 1000);
    expectTruth(growth, segmentation, "hurried");
    expectEqualsFresh(growth, segmentation, "hurried");
}

TEST_F(SegmentationTest, WhatWasScrubbedPlainIsSmoothedLater) {
    const auto volume = randomVolume({70, 50, 41}, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
    Segmentation segmentation(volume.geometry);
    Constraints constraints;
    constraints.range = {0, 60};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{15, 15, 15}, {16, 16, 16}, {40, 20, 33}});
    growth.advance(20);
    segmentation.update(growth);
    for (const int generation : {15, 9, 3, 12, 20, 11}) {
        growth.setPlayhead(generation);
        segmentation.update(growth, Smoothing::Plain);
        expectTruth(growth, segmentation, fmt::format("plain {}", generation));
    }
    segmentation.update(growth);
    expectTruth(growth, segmentation, "smooth again");
    expectEqualsFresh(growth, segmentation, "smooth again");
}

} // namespace
} // namespace vs::segment

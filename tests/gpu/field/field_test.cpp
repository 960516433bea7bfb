// SPDX-License-Identifier: Apache-2.0
#include "field/cell_ranges.h"
#include "field/field.h"
#include "field/histogram.h"
#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "volume/grid/histogram.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace vs::field {
namespace {

using FieldTest = test::GlTest;

volume::Volume randomVolume(glm::ivec3 dims, volume::ScalarType type, double lo, double hi) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(lo, hi);
    return phantom::makePhantom(dims, type, [&](glm::dvec3) { return value(random); });
}

TEST_F(FieldTest, HistogramEqualsTheOneCountedOnTheCpu) {
    using enum volume::ScalarType;
    for (const auto type : {UInt8, Int8, UInt16, Int16, Int32, Float32}) {
        const auto volume = randomVolume({37, 21, 19}, type, type == UInt8 || type == UInt16 ? 0 : -100, 100);
        const auto onDevice = intensityHistogram(uploadVolume(volume), 64);
        const auto onCpu = volume::histogram(volume, 64);
        std::uint64_t atBorders = 0; // of whole numbers; rounding takes them to either side
        forEachVoxel({glm::ivec3(0), volume.geometry.dims}, [&](glm::ivec3 v, std::size_t) {
            const double bin = (volume.at(v) - volume.range.lo) * 64 / volume.range.width();
            atBorders += type != Float32 && std::abs(bin - std::round(bin)) < 1e-6 ? 1 : 0;
        });
        std::uint64_t moved = 0;
        std::uint64_t total = 0;
        for (std::size_t i = 0; i < onCpu.size(); ++i) {
            moved += std::uint64_t(std::abs(std::int64_t(onDevice[i]) - std::int64_t(onCpu[i])));
            total += onDevice[i];
        }
        EXPECT_EQ(total, volume.geometry.voxelCount()) << name(type);
        EXPECT_LE(moved, type == Float32 ? 4U : 2 * atBorders) << name(type);
    }
}

// Software renderers count where the volume is; of each kind of number, whole and in part.
TEST_F(FieldTest, HistogramsOfAVolumeAtHandEqualThoseOfTheDevice) {
    using enum volume::ScalarType;
    constexpr int kBins = 37; // a prime number: no whole number lies at the border of two bins
    for (const auto type : {UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32}) {
        const bool isSigned = type != UInt8 && type != UInt16 && type != UInt32;
        std::mt19937 random(11);
        std::uniform_int_distribution<int> value(isSigned ? -100 : 0, 100);
        const auto volume =
            phantom::makePhantom({37, 21, 19}, type, [&](glm::dvec3) { return double(value(random)); });
        Field field = uploadVolume(volume);
        const Box3 part{{3, 2, 5}, {30, 21, 17}};
        const auto whole = intensityHistogram(field, kBins);
        const auto ofPart = intensityHistogram(field, part, kBins);
        field.onHost = &volume;
        EXPECT_EQ(intensityHistogram(field, kBins), whole) << name(type);
        EXPECT_EQ(intensityHistogram(field, part, kBins), ofPart) << name(type);
        EXPECT_EQ(std::accumulate(ofPart.begin(), ofPart.end(), std::size_t(0)), part.volume());
    }
}

// Software renderers take them from the volume where it is at hand.
TEST_F(FieldTest, CellRangesOfAVolumeAtHandEqualThoseOfTheDevice) {
    using enum volume::ScalarType;
    for (const auto type : {UInt8, Int8, UInt16, Int16, Int32, Float32}) {
        for (const glm::ivec3 dims : {glm::ivec3(37, 21, 19), glm::ivec3(5, 1, 4), glm::ivec3(1, 9, 1)}) {
            const bool isSigned = type != UInt8 && type != UInt16;
            const auto volume = randomVolume(dims, type, isSigned ? -100 : 0, 100);
            Field field = uploadVolume(volume);
            const auto onDevice = computeCellRanges(field).cells.downloadAll<glm::vec2>();
            field.onHost = &volume;
            const auto atHand = computeCellRanges(field).cells.downloadAll<glm::vec2>();
            ASSERT_EQ(atHand.size(), onDevice.size()) << name(type);
            for (std::size_t i = 0; i < atHand.size(); ++i) {
                // Texels of whole numbers are rounded to single precision.
                EXPECT_NEAR(atHand[i].x, onDevice[i].x, 1e-6 * double(field.valueScale)) << name(type) << i;
                EXPECT_NEAR(atHand[i].y, onDevice[i].y, 1e-6 * double(field.valueScale)) << name(type) << i;
            }
        }
    }
}

TEST_F(FieldTest, NonFiniteVoxelsAreInNoBin) {
    auto volume = randomVolume({16, 16, 16}, volume::ScalarType::Float32, 0, 1);
    auto* values = reinterpret_cast<float*>(volume.bytes.data());
    values[5] = std::numeric_limits<float>::quiet_NaN();
    values[99] = std::numeric_limits<float>::infinity();
    volume::computeRange(volume);
    EXPECT_EQ(volume.nonFiniteCount, 2U);
    const auto counts = intensityHistogram(uploadVolume(volume), 32);
    std::uint64_t total = 0;
    for (const auto c : counts) {
        total += c;
    }
    EXPECT_EQ(total, volume.geometry.voxelCount() - 2);
}

// What is cut and what is left are all voxels together, and each is what the CPU counts.
TEST_F(FieldTest, VisibleHistogramsCountEachSideOfTheCut) {
    const glm::ivec3 dims(37, 21, 19);
    const auto volume = randomVolume(dims, volume::ScalarType::UInt8, 0, 200);
    const Field field = uploadVolume(volume);
    constexpr int kBins = 50;
    std::vector<float> cut(volume.geometry.voxelCount());
    std::vector<std::uint32_t> expected(kBins);
    for (std::size_t i = 0; i < cut.size(); ++i) {
        cut[i] = float(i % 7) / 6; // one of them at exactly 0.5: cut
        const int n = int(i);
        const double value = volume.at({n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y});
        if (cut[i] < 0.5F) {
            ++expected[std::size_t(
                std::min(int((value - field.range.lo) / field.range.width() * kBins), kBins - 1))];
        }
    }
    gl::Texture sculpture(dims, gl::Format::R32F, gl::Filter::Nearest, "cut");
    sculpture.upload({glm::ivec3(0), dims}, std::as_bytes(std::span(cut)));
    VisibleHistogram counting(field, kBins);
    const auto count = [&](SculptureView view) {
        counting.start(view);
        while (!counting.advance(sculpture, 0)) {
        }
        return counting.counts();
    };
    const auto left = count(SculptureView::Cut);
    const auto away = count(SculptureView::Probe);
    const auto all = intensityHistogram(field, kBins);
    std::uint64_t moved = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_EQ(left[i] + away[i], all[i]);
        moved += std::uint64_t(std::abs(std::int64_t(left[i]) - std::int64_t(expected[i])));
    }
    EXPECT_LE(moved, volume.geometry.voxelCount() / 50); // on a bin's border either side is right
}

TEST_F(FieldTest, CellRangesBoundEveryTrilinearSample) {
    const auto volume = randomVolume({23, 9, 14}, volume::ScalarType::Int16, -500, 3000);
    const Field field = uploadVolume(volume);
    const CellRanges ranges = computeCellRanges(field);
    const auto cells = ranges.cells.downloadAll<glm::vec2>();
    const glm::ivec3 cellCount = cellDims(volume.geometry.dims);
    EXPECT_EQ(cellCount, glm::ivec3(6, 2, 4));
    for (int z = 0; z < 14; ++z) {
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 23; ++x) {
                const double value = volume.at({x, y, z});
                for (int corner = 0; corner < 8; ++corner) { // all cells that share this voxel as a corner
                    const glm::ivec3 back(corner & 1, (corner >> 1) & 1, corner >> 2);
                    const glm::ivec3 cell =
                        glm::clamp((glm::ivec3(x, y, z) - back) / kCell, glm::ivec3(0), cellCount - 1);
                    const glm::vec2 bounds =
                        cells[std::size_t((cell.z * cellCount.y + cell.y) * cellCount.x + cell.x)];
                    EXPECT_GE(value, bounds.x - 0.01);
                    EXPECT_LE(value, bounds.y + 0.01);
                }
            }
        }
    }
}

TEST_F(FieldTest, OtsuSeparatesAirFromObject) {
    const auto ball = phantom::makeBall({48, 48, 48}, {24, 24, 24}, 15, 200, 10);
    const Field field = uploadVolume(ball);
    const Range range = suggestRange(intensityHistogram(field), field.range);
    EXPECT_GT(range.lo, 20);
    EXPECT_LT(range.lo, 190);
    EXPECT_EQ(range.hi, 200);
}

} // namespace
} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/statistics.h"

#include "base/statistics.h"
#include "masks.h"
#include "phantom/phantom.h"
#include "segment/measures/surface_area.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace vs::segment {
namespace {

using volume::ScalarType;
using volume::Volume;

// The same by a plain loop over the voxels of one label.
SegmentStatistics reference(const Volume& volume, const std::vector<std::uint8_t>& labels,
                            std::uint8_t label) {
    SegmentStatistics result;
    result.label = label;
    std::vector<double> values;
    glm::dvec3 places(0);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != label) {
            continue;
        }
        const glm::ivec3 dims = volume.geometry.dims;
        const glm::ivec3 voxel(int(i) % dims.x, int(i) / dims.x % dims.y, int(i) / dims.x / dims.y);
        ++result.voxels;
        result.box = unite(result.box, {voxel, voxel + 1});
        places += glm::dvec3(volume.geometry.worldFromVoxel * glm::dvec4(voxel, 1));
        if (std::isfinite(volume.at(voxel))) {
            values.push_back(volume.at(voxel));
        }
    }
    result.centroid = places / double(result.voxels);
    result.intensities.voxels = values.size();
    if (values.empty()) {
        return result;
    }
    const auto n = double(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double v : values) {
        squares += (v - mean) * (v - mean);
    }
    result.intensities.mean = mean;
    result.intensities.deviation = std::sqrt(squares / n);
    result.intensities.smallest = *std::min_element(values.begin(), values.end());
    result.intensities.largest = *std::max_element(values.begin(), values.end());
    result.intensities.median = median(values);
    return result;
}

void expectSame(const Volume& volume, const std::vector<std::uint8_t>& labels) {
    const auto measured = measure(volume, labels);
    std::size_t voxels = 0;
    for (const SegmentStatistics& record : measured) {
        const auto truth = reference(volume, labels, record.label);
        SCOPED_TRACE(int(record.label));
        voxels += record.voxels;
        EXPECT_EQ(record.voxels, truth.voxels);
        EXPECT_DOUBLE_EQ(record.millilitres, double(truth.voxels) * volume.geometry.voxelMm3() / 1000);
        EXPECT_EQ(record.box, truth.box);
        EXPECT_LT(glm::distance(record.centroid, truth.centroid), 1e-9);
        const Intensities& a = record.intensities;
        const Intensities& b = truth.intensities;
        ASSERT_EQ(a.voxels, b.voxels);
        if (b.voxels == 0) {
            EXPECT_TRUE(std::isnan(a.mean) && std::isnan(a.deviation) && std::isnan(a.smallest) &&
                        std::isnan(a.largest) && std::isnan(a.median));
            continue;
        }
        const double rounding = 1e-12 * (std::abs(b.mean) + b.deviation + 1);
        EXPECT_NEAR(a.mean, b.mean, rounding);
        EXPECT_NEAR(a.deviation, b.deviation, 1e-9 * (b.deviation + 1));
        EXPECT_EQ(a.smallest, b.smallest);
        EXPECT_EQ(a.largest, b.largest);
        EXPECT_EQ(a.median, b.median);
    }
    EXPECT_EQ(voxels, labels.size() - std::size_t(std::count(labels.begin(), labels.end(), 0)));
}

std::vector<std::uint8_t> randomLabels(const volume::GridGeometry& grid, std::mt19937& random) {
    std::uniform_int_distribution<int> choose(0, 9);
    return labelsWhere(grid, [&](glm::dvec3 p) {
        const int label = choose(random);
        return label < 4 ? int(p.x) / 10 + 1 : label == 9 ? 255 : label == 8 ? 200 : 0;
    });
}

TEST(Statistics, AreThoseOfAPlainLoop) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 300);
    for (const ScalarType type : {ScalarType::UInt8, ScalarType::Int8, ScalarType::UInt16, ScalarType::Int16,
                                  ScalarType::UInt32, ScalarType::Int32, ScalarType::Float32}) {
        SCOPED_TRACE(volume::name(type));
        const double offset = type == ScalarType::UInt16 || type == ScalarType::UInt32 ? 3000 : 0;
        auto volume = phantom::makePhantom(
            {37, 22, 19}, type, [&](glm::dvec3) { return offset + normal(random); }, {0.7, 1, 2.5});
        volume.geometry.worldFromVoxel =
            glm::rotate(glm::dmat4(1), 0.4, glm::dvec3(1, 1, 0)) * volume.geometry.worldFromVoxel;
        expectSame(volume, randomLabels(volume.geometry, random));
    }
}

TEST(Statistics, OfWideWholeNumbersAndAwkwardFloats) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> wide(0, 4e9);
    const auto counts =
        phantom::makePhantom({20, 21, 22}, ScalarType::UInt32, [&](glm::dvec3) { return wide(random); });
    expectSame(counts, randomLabels(counts.geometry, random));
    // One voxel far away puts all others into one bin; infinities and NaN are left out.
    std::normal_distribution<double> normal(5, 1);
    auto floats =
        phantom::makePhantom({20, 21, 22}, ScalarType::Float32, [&](glm::dvec3) { return normal(random); });
    const auto labels = randomLabels(floats.geometry, random);
    auto* values = reinterpret_cast<float*>(floats.bytes.data());
    values[17] = 1e30F;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] == 255 || i % 7 == 0) {
            values[i] =
                i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
        }
    }
    volume::computeRange(floats);
    expectSame(floats, labels);
}

TEST(Statistics, OfOneValueAndOfNothing) {
    const auto flat = phantom::makePhantom({5, 4, 3}, ScalarType::Float32, [](glm::dvec3) { return -0.25; });
    const std::vector<std::uint8_t> all(60, 1);
    expectSame(flat, all);
    EXPECT_EQ(measure(flat, all).front().intensities.deviation, 0);
    EXPECT_TRUE(measure(flat, std::vector<std::uint8_t>(60, 0)).empty());
}

TEST(Statistics, OfABall) {
    const auto ball = phantom::makeBall({60, 60, 60}, glm::dvec3(31, 28, 29), 20, 200, 0, 4);
    const auto labels = labelsWhere(ball.geometry, [](glm::dvec3 p) {
        return isInEllipsoid(p - glm::dvec3(31, 28, 29), glm::dvec3(20));
    });
    const auto records = measure(ball, labels);
    ASSERT_EQ(records.size(), 1U);
    const SegmentStatistics& record = records.front();
    const double pi = glm::pi<double>();
    EXPECT_NEAR(record.millilitres, 4 * pi * 8 / 3, 0.005 * 4 * pi * 8 / 3); // voxels whose centre is inside
    EXPECT_LT(glm::distance(record.centroid, {31, 28, 29}), 1e-9);
    EXPECT_EQ(record.box, (Box3{{11, 8, 9}, {52, 49, 50}}));
    EXPECT_EQ(record.boxMm, glm::dvec3(41));
    EXPECT_EQ(record.surfaceMm2, surfaceAreas(ball.geometry, labels)[1]);
    EXPECT_EQ(record.intensities.smallest, 100); // on the sphere
    EXPECT_EQ(record.intensities.median, 200);
}

} // namespace
} // namespace vs::segment

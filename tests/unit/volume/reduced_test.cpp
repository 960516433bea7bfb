// SPDX-License-Identifier: Apache-2.0
#include "phantom/phantom.h"
#include "property.h"
#include "volume/grid/reduced.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace vs::volume {
namespace {

Volume volumeOf(glm::ivec3 dims, const std::vector<float>& values, glm::dvec3 spacing = glm::dvec3(1)) {
    Volume volume;
    volume.geometry = makeGeometry(dims, spacing);
    volume.type = ScalarType::Float32;
    const auto bytes = std::as_bytes(std::span(values));
    volume.bytes.assign(bytes.begin(), bytes.end());
    return volume;
}

// A plane of values stays that plane: what was measured at a place is found at that place.
TEST(Reduced, KeepsAPlaneInPlace) {
    test::checkProperty(100, [] {
        const glm::ivec3 by(1 + *test::below(4), 1 + *test::below(4), 1 + *test::below(4));
        const glm::ivec3 blocks(1 + *test::below(4), 1 + *test::below(4), 1 + *test::below(4));
        const glm::dvec3 slope(0.5, -0.25, 2);
        const glm::ivec3 dims = blocks * by;
        const auto spacing = glm::dvec3(0.7, 1.1, 2.5);
        std::vector<float> values;
        for (int k = 0; k < dims.z; ++k) {
            for (int j = 0; j < dims.y; ++j) {
                for (int i = 0; i < dims.x; ++i) {
                    values.push_back(float(glm::dot(slope, glm::dvec3(i, j, k) * spacing)));
                }
            }
        }
        const Volume small = reduced(volumeOf(dims, values, spacing), by, Reducing::Mean);
        RC_ASSERT(small.geometry.dims == blocks);
        for (int k = 0; k < blocks.z; ++k) {
            for (int j = 0; j < blocks.y; ++j) {
                for (int i = 0; i < blocks.x; ++i) {
                    const glm::dvec3 world(small.geometry.worldFromVoxel * glm::dvec4(i, j, k, 1));
                    RC_ASSERT(std::abs(small.at({i, j, k}) - glm::dot(slope, world)) < 1e-4);
                }
            }
        }
    });
}

// Each voxel belongs to one block: whole numbers, blocks that are cut short, against counting by hand.
TEST(Reduced, BlocksAreThoseThatOneCounts) {
    test::checkProperty(100, [] {
        const glm::ivec3 dims(1 + *test::below(8), 1 + *test::below(8), 1 + *test::below(8));
        const glm::ivec3 by(1 + *test::below(3), 1 + *test::below(3), 1 + *test::below(3));
        Volume volume;
        volume.geometry = makeGeometry(dims);
        volume.type = ScalarType::Int8;
        const auto values = *rc::gen::container<std::vector<std::int8_t>>(
            volume.geometry.voxelCount(), rc::gen::inRange<std::int8_t>(-3, 4));
        const auto bytes = std::as_bytes(std::span(values));
        volume.bytes.assign(bytes.begin(), bytes.end());
        const Volume mean = reduced(volume, by, Reducing::Mean);
        const Volume commonest = reduced(volume, by, Reducing::Commonest);
        std::map<std::array<int, 3>, std::map<double, int>> blocks;
        for (int k = 0; k < dims.z; ++k) {
            for (int j = 0; j < dims.y; ++j) {
                for (int i = 0; i < dims.x; ++i) {
                    ++blocks[{i / by.x, j / by.y, k / by.z}][volume.at({i, j, k})];
                }
            }
        }
        RC_ASSERT(blocks.size() == mean.geometry.voxelCount());
        for (const auto& [place, counts] : blocks) {
            double sum = 0;
            int all = 0;
            std::pair<double, int> most{0, 0};
            for (const auto& [value, count] : counts) {
                sum += value * count;
                all += count;
                most = count > most.second ? std::pair(value, count) : most;
            }
            const glm::ivec3 at(place[0], place[1], place[2]);
            RC_ASSERT(mean.at(at) == double(std::lround(sum / all)));
            RC_ASSERT(commonest.at(at) == most.first);
        }
    });
}

TEST(Reduced, WhatWasNotMeasuredIsLeftOutOfMeans) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto volume = volumeOf({8, 1, 1}, {1, nan, 1e30F, 3, nan, nan, 1e30F, 1e30F});
    const Volume small = reduced(volume, {2, 1, 1}, Reducing::Mean);
    EXPECT_EQ(small.at({0, 0, 0}), 1);
    EXPECT_EQ(small.at({1, 0, 0}), 3);
    EXPECT_TRUE(std::isnan(small.at({2, 0, 0})));
    EXPECT_EQ(small.at({3, 0, 0}), double(1e30F));
    EXPECT_EQ(small.nonFiniteCount, 1U);
    const Volume labels = reduced(volumeOf({3, 1, 1}, {nan, nan, 5}), {3, 1, 1}, Reducing::Commonest);
    EXPECT_EQ(labels.geometry.dims, glm::ivec3(1));
}

} // namespace
} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
// A field that is linear in the world stays exactly what it is, however its slices lie: linear resampling is
// exact on it, so any slice put in the wrong place shows.
#include "volume/dicom/dicom.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace vs::volume {
namespace {

double field(glm::dvec3 world) { return 3 * world.x - 2 * world.y + 5 * world.z + 100; }

// Slices at the given distances along their normal, each shifted by `slant` mm per mm along the second axis.
SliceStack makeStack(const std::vector<double>& offsets, double slant) {
    SliceStack stack;
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 0.5, glm::normalize(glm::dvec3(1, 3, -2))));
    stack.alongColumns = turn[0];
    stack.alongRows = turn[1];
    stack.pixelSpacing = {0.8, 1.25};
    stack.volume.type = ScalarType::Float32;
    stack.volume.geometry.dims = {11, 9, int(offsets.size())};
    std::vector<float> values;
    for (const double offset : offsets) {
        stack.positions.push_back(glm::dvec3(-20, 5, 40) + turn[2] * offset + turn[1] * (slant * offset));
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 11; ++x) {
                values.push_back(
                    float(field(stack.positions.back() + turn[0] * (0.8 * x) + turn[1] * (1.25 * y))));
            }
        }
    }
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    stack.volume.bytes.assign(bytes, bytes + values.size() * sizeof(float));
    return stack;
}

// Voxels between slices on both sides must hold the field; those outside one slice were filled.
double largestError(const Volume& volume, int margin) {
    double largest = 0;
    const auto dims = volume.geometry.dims;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = margin; y < dims.y - margin; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const glm::dvec3 world(volume.geometry.worldFromVoxel * glm::dvec4(x, y, z, 1));
                largest = std::max(largest, std::abs(volume.at({x, y, z}) - field(world)));
            }
        }
    }
    return largest;
}

TEST(Resample, EvenSlicesAreLeftAlone) {
    auto stack = makeStack({0, 2, 4, 6}, 0);
    const auto before = stack.volume.bytes;
    std::vector<std::string> notices;
    makeRegular("s", stack, notices);
    EXPECT_TRUE(notices.empty());
    EXPECT_EQ(stack.volume.bytes, before);
    EXPECT_LT(largestError(stack.volume, 0), 1e-4);
}

TEST(Resample, MissingAndUnevenSlicesKeepTheField) {
    const std::pair<std::vector<double>, int> cases[] = {{{0, 1, 2, 4, 5}, 6},
                                                         {{0, 0.8, 2, 2.4, 4, 4.8}, 13},
                                                         {{0, 4.002, 8.004, 9.085, 16.084}, 16},
                                                         {{0, 1, 3.3}, 11}};
    for (const auto& [offsets, slices] : cases) {
        auto stack = makeStack(offsets, 0);
        std::vector<std::string> notices;
        makeRegular("s", stack, notices);
        EXPECT_EQ(notices.size(), 1U);
        EXPECT_EQ(stack.volume.geometry.dims.z, slices) << notices[0];
        EXPECT_LT(largestError(stack.volume, 0), 2e-3) << notices[0];
        const glm::dvec3 last(stack.volume.geometry.worldFromVoxel *
                              glm::dvec4(0, 0, stack.volume.geometry.dims.z - 1, 1));
        EXPECT_NEAR(glm::length(last - stack.positions.back()), 0, 1e-9);
    }
}

TEST(Resample, TiltIsStraightenedAndCoversAllSlices) {
    for (const double slant : {0.3, -0.3}) {
        auto stack = makeStack({0, 1, 2, 3}, slant);
        std::vector<std::string> notices;
        makeRegular("s", stack, notices);
        ASSERT_EQ(notices.size(), 1U);
        EXPECT_NE(notices[0].find("tilted by 16.7 degrees"), std::string::npos) << notices[0];
        EXPECT_EQ(stack.volume.geometry.dims, glm::ivec3(11, 10, 4));
        const auto& m = stack.volume.geometry.worldFromVoxel;
        EXPECT_NEAR(glm::dot(glm::dvec3(m[1]), glm::dvec3(m[2])), 0, 1e-12);
        EXPECT_LT(largestError(stack.volume, 1), 2e-3);
    }
}

} // namespace
} // namespace vs::volume

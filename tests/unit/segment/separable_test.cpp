// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/separable.h"

#include <gtest/gtest.h>

#include <numeric>

namespace vs::segment {
namespace {

TEST(FilterAlong, IsTheSumOverNeighboursAlongItsAxis) {
    const glm::ivec3 size(5, 4, 6);
    const std::vector<float> weights{1, 10, 100, 1000, 10000}; // not symmetric: order shows
    std::vector<float> before(std::size_t(size.x * size.y * size.z));
    std::iota(before.begin(), before.end(), 1.0F);
    const auto at = [&](glm::ivec3 v) { return before[std::size_t(v.x + size.x * (v.y + size.y * v.z))]; };
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> after = before;
        filterAlong(axis, after, size, weights, 0.0F,
                    [](float sum, float neighbour, float weight) { return sum + weight * neighbour; });
        std::size_t next = 0;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    float expected = 0;
                    for (int k = -2; k <= 2; ++k) {
                        glm::ivec3 neighbour(x, y, z);
                        neighbour[axis] = std::clamp(neighbour[axis] + k, 0, size[axis] - 1);
                        expected += weights[std::size_t(k + 2)] * at(neighbour);
                    }
                    EXPECT_EQ(after[next++], expected) << "axis " << axis; // whole numbers below 2^24
                }
            }
        }
    }
}

} // namespace
} // namespace vs::segment

// SPDX-License-Identifier: Apache-2.0
#include "base/statistics.h"

#include <gtest/gtest.h>

namespace vs {
namespace {

TEST(Median, IsTheMiddleValueWhateverTheOrder) {
    EXPECT_EQ(median({5, 1, 9}), 5);
    EXPECT_EQ(median({9, 5, 1}), 5);
    EXPECT_EQ(median({7}), 7);
}

TEST(Median, OfAnEvenCountLiesBetweenTheTwoInTheMiddle) {
    EXPECT_EQ(median({4, 1, 100, 2}), 3);
    EXPECT_EQ(median({2, 2}), 2);
}

TEST(Median, IsNotMovedByOneOutlier) { EXPECT_EQ(median({10, 10, 10, 10, 1e9}), 10); }

TEST(Median, OfNothingIsZero) { EXPECT_EQ(median({}), 0); }

} // namespace
} // namespace vs

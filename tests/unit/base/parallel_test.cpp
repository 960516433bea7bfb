// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace vs {
namespace {

TEST(InParallel, EachOnceAndFailuresCome) {
    for (const int threads : {1, 3, 500}) {
        std::vector<std::atomic<int>> calls(300);
        inParallel(300, threads, [&](int i) { ++calls[std::size_t(i)]; });
        for (const auto& count : calls) {
            EXPECT_EQ(count, 1) << threads << " threads";
        }
    }
    inParallel(0, [](int) { FAIL() << "called for nothing"; });
    std::atomic<int> calls = 0;
    const auto fail = [&](int i) {
        ++calls;
        if (i == 150) {
            throw std::runtime_error("no room");
        }
    };
    EXPECT_THROW(inParallel(300, fail), std::runtime_error);
    EXPECT_EQ(calls, 300) << "one that fails does not keep the others from their turns";
}

} // namespace
} // namespace vs

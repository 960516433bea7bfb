// SPDX-License-Identifier: Apache-2.0
#include "base/crew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vs {
namespace {

TEST(Crew, DoesEachPartOnceHoweverManyThereAre) {
    for (const int threads : {1, 2, 5}) {
        Crew crew(threads);
        for (std::size_t count = 0; count < 300; ++count) {
            std::vector<int> done(count);
            crew.run(count, 1 + count % 7, [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) {
                    ++done[i];
                }
            });
            EXPECT_EQ(done, std::vector<int>(count, 1));
        }
    }
}

// What a call wrote before is seen by every part of the next.
TEST(Crew, OneCallFollowsTheOther) {
    Crew crew(3);
    std::vector<int> numbers(1000, 0);
    for (int call = 0; call < 2000; ++call) {
        crew.run(numbers.size(), 10, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                numbers[i] = numbers[i] == call ? call + 1 : -1;
            }
        });
        std::reverse(numbers.begin(), numbers.end()); // other threads' numbers, mostly
    }
    EXPECT_EQ(numbers, std::vector<int>(1000, 2000));
}

TEST(Crew, GoesHomeWithoutWork) {
    for (int i = 0; i < 50; ++i) {
        const Crew crew(4);
    }
}

} // namespace
} // namespace vs

// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/rest_clock.h"

#include <gtest/gtest.h>

namespace vs::volume {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr milliseconds kStep{50};

// Looks for so long at a process that does not work. Returns its rest.
std::chrono::nanoseconds lookFor(RestClock& clock, RestClock::Moment& now, std::chrono::nanoseconds how) {
    std::chrono::nanoseconds rest{0};
    for (std::chrono::nanoseconds passed{0}; passed < how; passed += kStep) {
        now += kStep;
        rest = clock.look(now, milliseconds(7));
    }
    return rest;
}

TEST(RestClock, CountsWhatPassesWhileNothingIsDone) {
    RestClock::Moment now{};
    RestClock clock(now);
    lookFor(clock, now, kStep); // it had worked until then
    EXPECT_EQ(lookFor(clock, now, minutes(2)), minutes(2));
}

TEST(RestClock, BeginsAnewWithWork) {
    RestClock::Moment now{};
    RestClock clock(now);
    lookFor(clock, now, minutes(2));
    EXPECT_EQ(clock.look(now += kStep, milliseconds(8)), seconds(0));
    EXPECT_EQ(clock.look(now += kStep, milliseconds(8)), kStep);
    EXPECT_EQ(clock.look(now += kStep, std::nullopt), seconds(0));
}

// Both were stopped, as when a machine is suspended: the process had no more time than whoever looks.
TEST(RestClock, LeavesOutWhatNobodySaw) {
    RestClock::Moment now{};
    RestClock clock(now);
    lookFor(clock, now, seconds(10));
    now += std::chrono::hours(3);
    EXPECT_LT(lookFor(clock, now, kStep), seconds(12));
}

} // namespace
} // namespace vs::volume

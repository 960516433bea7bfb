// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace vs {

// Wall-clock stopwatch, started when made.
class Timer {
public:
    [[nodiscard]] double milliseconds() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }

    // The machine's steady clock, in ms since some moment.
    [[nodiscard]] static double now() {
        return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

} // namespace vs

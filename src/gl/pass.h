// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"

#include <array>
#include <map>
#include <string>

namespace vs::gl {

// What each named pass has taken while timing is on: milliseconds of wall clock and of the device's own clock
// (timer queries).
struct PassTimes {
    double milliseconds = 0;
    double deviceMilliseconds = 0;
    int count = 0;
};

// Names a piece of GPU work for debuggers (a debug group) and for the timing table. Opened at the start of
// the block that dispatches the work, closed at its end. With timing on, each pass waits for the device at
// both ends, so its time is its own; with timing off it costs next to nothing.
class Pass {
public:
    explicit Pass(const char* name);
    ~Pass();
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;

    // The names of the passes that are open on this thread, from the outermost on, or nothing.
    static std::string openNames();

    static void enableTiming(bool enabled);
    static const std::map<std::string, PassTimes>& times();
    static void resetTimes();

private:
    const char* name_;
    Pass* outer_; // the pass that this one lies in
    Timer timer_;
    std::array<unsigned, 2> stamps_{}; // timer queries at both ends, while timing is on
};

} // namespace vs::gl

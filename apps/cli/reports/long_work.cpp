// SPDX-License-Identifier: Apache-2.0
#include "reports/long_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <ctime>

namespace vs::cli {

namespace {

volatile std::sig_atomic_t isInterrupted = 0;
volatile std::sig_atomic_t lastToldAt = 0; // seconds of the system's clock; 0: never
constexpr int kLongAgo = 3;                // seconds

// Of a clock that signal handlers may ask.
std::sig_atomic_t now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::sig_atomic_t(time.tv_sec);
}

void interrupt(int /*signal*/) {
    isInterrupted = 1;
    std::signal(SIGINT, SIG_DFL);
    if (lastToldAt == 0 || now() - lastToldAt > kLongAgo) {
        std::raise(SIGINT);
    }
}

std::string roughly(double seconds) {
    return seconds < 90     ? fmt::format("{:.0f} s", seconds)
           : seconds < 5400 ? fmt::format("{:.0f} min", seconds / 60)
                            : fmt::format("{:.1f} h", seconds / 3600);
}

// "34 %, about 2 min left", of work that has taken so long and was at `first` in the beginning.
std::string textOf(double share, double first, double seconds) {
    constexpr double kLeast = 0.01; // that is done before the rest can be told
    const std::string done = fmt::format("{:.0f} %", 100 * share);
    return share - first < kLeast
               ? done
               : fmt::format("{}, about {} left", done, roughly(seconds * (1 - share) / (share - first)));
}

} // namespace

LongWork::LongWork(const std::string& what)
    : clock_(what), line_(what, 0), listener_([this](std::optional<double> share) { return tell(share); }) {
    isInterrupted = 0;
    lastToldAt = 0;
    handler_ = std::signal(SIGINT, interrupt);
    if (handler_ == SIG_IGN) { // as of what runs in the background of a script
        std::signal(SIGINT, SIG_IGN);
    }
}

LongWork::~LongWork() { std::signal(SIGINT, handler_); }

bool LongWork::tell(std::optional<double> share) {
    lastToldAt = now();
    if (share) {
        clock_.reset();
        first_ = first_.value_or(*share);
        most_ = std::max(most_, *share);
        line_.show(textOf(most_, *first_, timer_.milliseconds() / 1000));
    }
    return isInterrupted == 0;
}

} // namespace vs::cli

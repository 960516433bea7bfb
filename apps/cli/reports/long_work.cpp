// SPDX-License-Identifier: Apache-2.0
#include "reports/long_work.h"

#include <fmt/format.h>

#include <csignal>

namespace vs::cli {

namespace {

volatile std::sig_atomic_t isInterrupted = 0;

void interrupt(int /*signal*/) {
    isInterrupted = 1;
    std::signal(SIGINT, SIG_DFL);
}

std::string roughly(double seconds) {
    return seconds < 90     ? fmt::format("{:.0f} s", seconds)
           : seconds < 5400 ? fmt::format("{:.0f} min", seconds / 60)
                            : fmt::format("{:.1f} h", seconds / 3600);
}

} // namespace

std::string progressText(double share, double first, double seconds) {
    constexpr double kLeast = 0.01; // that is done before the rest can be told
    const std::string done = fmt::format("{:.0f} %", 100 * share);
    return share - first < kLeast
               ? done
               : fmt::format("{}, about {} left", done, roughly(seconds * (1 - share) / (share - first)));
}

LongWork::LongWork(const std::string& what)
    : line_(what, 0), listener_([this](std::optional<double> share) { return tell(share); }) {
    isInterrupted = 0;
    std::signal(SIGINT, interrupt);
}

LongWork::~LongWork() { std::signal(SIGINT, SIG_DFL); }

bool LongWork::tell(std::optional<double> share) {
    if (share) {
        first_ = first_.value_or(*share);
        line_.show(progressText(*share, *first_, timer_.milliseconds() / 1000));
    }
    return isInterrupted == 0;
}

} // namespace vs::cli

// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace vs::cli {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), isTerminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (isShown_) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::advance(std::size_t amount) {
    done_ = std::min(done_ + amount, total_);
    if (!isTerminal_ || total_ == 0 || timer_.milliseconds() < 1000) {
        return;
    }
    constexpr std::size_t width = 30;
    const std::size_t filled = width * done_ / total_;
    fmt::print(stderr, "\r{} [{}{}] {}/{}", what_, std::string(filled, '='), std::string(width - filled, ' '),
               done_, total_);
    std::fflush(stderr);
    isShown_ = true;
}

void Progress::show(const std::string& soFar) {
    if (isTerminal_ && timer_.milliseconds() >= 1000) {
        fmt::print(stderr, "\r\033[K{} {}", what_, soFar);
        std::fflush(stderr);
        isShown_ = true;
    }
}

} // namespace vs::cli

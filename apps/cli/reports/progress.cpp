// SPDX-License-Identifier: Apache-2.0
#include "reports/progress.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
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

namespace {

// One system call, no stream: nothing is locked when another thread forks.
void writeTo(int file, const std::string& text) {
    [[maybe_unused]] const auto written = write(file, text.data(), text.size());
}

} // namespace

Activity::Activity(std::string what) {
    if (isatty(STDERR_FILENO) != 1) {
        return;
    }
    terminal_ = dup(STDERR_FILENO);
    thread_ = std::jthread([this, text = std::move(what)](const std::stop_token& stop) {
        const Timer timer;
        std::unique_lock lock(mutex_);
        while (!wake_.wait_for(lock, stop, std::chrono::seconds(1), [&] { return stop.stop_requested(); })) {
            isShown_ = true;
            writeTo(terminal_, fmt::format("\r\033[K{} ... {:.0f} s", text, timer.milliseconds() / 1000));
        }
    });
}

Activity::~Activity() {
    if (terminal_ >= 0) {
        thread_.request_stop();
        thread_.join();
        if (isShown_) {
            writeTo(terminal_, "\r\033[K");
        }
        close(terminal_);
    }
}

} // namespace vs::cli

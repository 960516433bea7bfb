// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace vs::cli {

// A progress bar on standard error for work that takes over a second; silent when that is not a terminal. The
// line is wiped when the work ends.
class Progress {
public:
    Progress(std::string what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance(std::size_t amount = 1);
    void show(const std::string& soFar);
    // Whether the bar would be shown; if not, the work need not be cut into pieces.
    [[nodiscard]] bool isTerminal() const { return isTerminal_; }

private:
    std::string what_;
    std::size_t total_;
    std::size_t done_ = 0;
    bool isTerminal_;
    bool isShown_ = false;
    Timer timer_;
};

// Says on a terminal that something of unknown length is under way, and for how long, once it has taken a
// second.
class Activity {
public:
    explicit Activity(std::string what);
    ~Activity();
    Activity(const Activity&) = delete;
    Activity& operator=(const Activity&) = delete;

private:
    int terminal_ =
        -1; // a copy of standard error, which libraries may be silenced on meanwhile; -1: no terminal
    std::atomic<bool> isShown_ = false;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread thread_;
};

} // namespace vs::cli

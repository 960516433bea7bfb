// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/progress.h"

#include "base/progress.h"
#include "base/timer.h"

#include <optional>
#include <string>

namespace vs::cli {

// While it lives, what this thread's work tells of its progress (base/progress.h) is shown on a terminal,
// with about how long the rest takes; until it tells any, for how long it has been under way. Ctrl-C has the
// work given up where it tells next, or ends the program, if that is long ago or it comes again.
class LongWork {
public:
    explicit LongWork(const std::string& what);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

private:
    bool tell(std::optional<double> share);

    std::optional<Activity> clock_; // until a share is told
    Progress line_;
    Timer timer_;
    std::optional<double> first_; // of the shares told: work that is gone on with does not begin at 0
    double most_ = 0;             // of them: parts of the work may count for themselves
    ProgressListener listener_;
    void (*handler_)(int) = nullptr; // of SIGINT, before
};

} // namespace vs::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/progress.h"

#include "base/progress.h"
#include "base/timer.h"

#include <optional>
#include <string>

namespace vs::cli {

// While it lives, what this thread's work tells of its progress (base/progress.h) is shown on a terminal,
// with about how long the rest takes, and Ctrl-C has the work given up where it tells next; a second one ends
// the program at once.
class LongWork {
public:
    explicit LongWork(const std::string& what);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

private:
    bool tell(std::optional<double> share);

    Progress line_;
    Timer timer_;
    std::optional<double> first_; // of the shares told: work that is gone on with does not begin at 0
    ProgressListener listener_;
};

// What is shown of work that has taken so long and was at `first` in the beginning: "34 %, about 2 min left".
std::string progressText(double share, double first, double seconds);

} // namespace vs::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace vs::volume {

// For how long a process has not worked, as its processor time tells whoever looks again and again. What
// passes between two looks counts as a second at most: where nobody looked for longer, this program was
// stopped too, with a paused container or a laptop, and the process is not to blame. Internal to this folder.
class RestClock {
public:
    using Moment = std::chrono::steady_clock::time_point;

    explicit RestClock(Moment now = std::chrono::steady_clock::now()) : last_(now) {}

    // Looks at what it has used of the processor so far (nothing: that cannot be told, and counts as work).
    // Returns how long it has rested.
    std::chrono::nanoseconds look(Moment now, std::optional<std::chrono::nanoseconds> used) {
        constexpr std::chrono::nanoseconds longestLook = std::chrono::seconds(1);
        const bool works = !used || used != used_;
        rested_ = works ? std::chrono::nanoseconds(0)
                        : rested_ + std::min<std::chrono::nanoseconds>(now - last_, longestLook);
        used_ = used;
        last_ = now;
        return rested_;
    }

private:
    Moment last_;
    std::optional<std::chrono::nanoseconds> used_;
    std::chrono::nanoseconds rested_{0};
};

} // namespace vs::volume

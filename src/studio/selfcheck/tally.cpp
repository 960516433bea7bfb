// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/tally.h"

#include <cmath>
#include <limits>

namespace vs::studio {

void Tally::compare(double found, double expected, double allowed) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double difference = std::abs(found - expected);
    const double error = std::isnan(difference) ? infinite : difference;
    ++values_;
    const bool isWrong = error > allowed;
    wrong_ += isWrong ? 1 : 0;
    const double share = allowed > 0 ? error / allowed : isWrong ? infinite : 0;
    // Of values that must be equal the largest error counts.
    if (share > worst_.share || (std::isinf(share) && error > worst_.error)) {
        worst_ = {what_, error, allowed, share};
    }
}

} // namespace vs::studio

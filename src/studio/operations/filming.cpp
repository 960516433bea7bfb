// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/filming.h"

#include <fmt/format.h>

namespace vs::studio {

Fault Shot::faultOf() const {
    for (std::size_t n = 1; n < keys.size(); ++n) {
        if (!(keys[n].seconds > keys[n - 1].seconds)) {
            return {fmt::format("keys[{}].at", n), "must come after the key before"};
        }
    }
    if (orbit == Orbit::Approach && !(amount >= 1e-3 && amount <= 1e3)) {
        return {"amount", "must be a factor from 0.001 to 1000"};
    }
    return {};
}

Fault SaveMovie::faultOf() const {
    double seconds = 0;
    for (const Shot& shot : shots) {
        seconds += shot.seconds;
    }
    if (seconds * framesPerSecond > kMostFrames) {
        return {"shots", fmt::format("must come to {} frames at most", kMostFrames)};
    }
    return {};
}

} // namespace vs::studio

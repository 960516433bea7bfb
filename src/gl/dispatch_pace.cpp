// SPDX-License-Identifier: Apache-2.0
#include "gl/dispatch_pace.h"

#include "gl/context.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vs::gl {

namespace {
constexpr double kLongestMs = 100;
constexpr double kFewInvocations = 65536; // soon done on any device
} // namespace

int DispatchPace::layers(int left, std::size_t perLayer) const {
    if (!std::isfinite(longestMs_)) {
        return left;
    }
    if (longestMs_ <= 0) {
        return 1;
    }
    const double invocations =
        nanosPerInvocation_ > 0 ? longestMs_ * 1e6 / nanosPerInvocation_ : kFewInvocations;
    return int(std::clamp(invocations / double(perLayer), 1.0, double(left)));
}

// The slower of late is believed: a clock may have been interrupted, but also the device be busy.
void DispatchPace::note(std::size_t invocations, double milliseconds) {
    const double nanos = milliseconds * 1e6 / double(invocations);
    nanosPerInvocation_ = std::max(nanos, 0.7 * nanosPerInvocation_);
}

double longestDispatchMs() {
    if (const char* asked = std::getenv("VOLUME_STUDIO_DISPATCH_MS")) {
        return std::atof(asked);
    }
    return Context::isSoftware() ? std::numeric_limits<double>::infinity() : kLongestMs;
}

} // namespace vs::gl

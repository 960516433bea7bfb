// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace vs::gl {

// How many layers of one dispatch are submitted at once, by how long those before took: a driver resets a
// device that is busy with one submission for seconds (two on Windows), and nobody is answered meanwhile.
class DispatchPace {
public:
    // No submission is to take longer than about `longestMs`; infinite: all is submitted at once.
    explicit DispatchPace(double longestMs) : longestMs_(longestMs) {}

    // How many of the layers that are left, of so many invocations each, go into the next submission: at
    // least one, and no more than a few where nothing is known yet and there are many.
    [[nodiscard]] int layers(int left, std::size_t perLayer) const;
    // Takes note of what one took.
    void note(std::size_t invocations, double milliseconds);

private:
    double longestMs_;
    double nanosPerInvocation_ = 0; // 0: not known yet
};

// What submissions may take on the current context's device: 100 ms on hardware, any time on a software
// renderer, which nobody resets. VOLUME_STUDIO_DISPATCH_MS in the environment says otherwise, for tests.
double longestDispatchMs();

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace vs::volume {

// Calls `work(z)` for each slice 0 <= z < count, on all cores, in no particular order. Slices must not depend
// on one another, and `work` must not throw.
template <typename Work>
void forEachSlice(int count, const Work& work) {
    std::atomic<int> next = 0;
    const auto run = [&] {
        for (int z = next++; z < count; z = next++) {
            work(z);
        }
    };
    std::vector<std::jthread> helpers;
    const int threads = std::clamp(int(std::thread::hardware_concurrency()), 1, count);
    for (int i = 1; i < threads; ++i) {
        helpers.emplace_back(run);
    }
    run();
}

} // namespace vs::volume

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace vs::segment {

// Threads that work on voxels at once: as many as there are cores, up to where memory is the limit.
inline int workerCount() { return std::clamp(int(std::thread::hardware_concurrency()), 1, 4); }

// Calls work(i) once for each i below count, on workerCount() threads. `work` must not throw.
template <typename F>
void inParallel(int count, const F& work) {
    std::atomic<int> next{0};
    const auto takeTurns = [&] {
        for (int i = next++; i < count; i = next++) {
            work(i);
        }
    };
    std::vector<std::jthread> others;
    for (int t = 1; t < std::min(workerCount(), count); ++t) {
        others.emplace_back(takeTurns);
    }
    takeTurns();
}

} // namespace vs::segment

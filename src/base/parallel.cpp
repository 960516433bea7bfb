// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vs {

int processorCount() { return std::max(int(std::thread::hardware_concurrency()), 1); }

int threadsForMemory() { return std::min(processorCount(), 4); }

void inParallel(int count, int threads, const std::function<void(int)>& work) {
    std::atomic<int> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto takeTurns = [&] {
        for (int i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                failure = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> others;
        for (int t = 1; t < std::min(threads, count); ++t) {
            others.emplace_back(takeTurns);
        }
        takeTurns();
    } // waits for the others
    if (failure) {
        std::rethrow_exception(failure);
    }
}

void inParallel(int count, const std::function<void(int)>& work) {
    inParallel(count, processorCount(), work);
}

} // namespace vs

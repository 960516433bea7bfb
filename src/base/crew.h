// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace vs {

// Threads that stay at hand for many short pieces of work, one after the other: a piece of some ten
// microseconds is worth their while, which is less than starting a thread takes. Nobody waits for one of them
// that has not begun: where all processors are busy, the caller does most of the work alone.
class Crew {
public:
    // So many threads, the caller's among them. Throws std::system_error where there can be no more.
    explicit Crew(int threads);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    // Calls work(first, last) for parts [first, last) of [0, count), of `atOnce` where others help, until all
    // are done. The calls must neither throw nor depend on one another. One caller at a time.
    void run(std::size_t count, std::size_t atOnce,
             const std::function<void(std::size_t, std::size_t)>& work);

private:
    struct Job {
        std::size_t count;
        std::size_t atOnce;
        const std::function<void(std::size_t, std::size_t)>* work;
        std::atomic<std::size_t> next = 0;

        void takeParts();
    };
    void serve();
    void sendHome();
    std::uint32_t nextCall(std::uint32_t last) const;

    std::atomic<std::uint32_t> calls_ = 0; // counts jobs
    std::atomic<Job*> job_ = nullptr;
    std::atomic<int> atWork_ = 0; // threads that may look at the job
    std::atomic<bool> isOver_ = false;
    int alone_ = 0; // as many calls are left to the caller alone
    std::vector<std::jthread> threads_;
};

} // namespace vs

// SPDX-License-Identifier: Apache-2.0
#include "base/crew.h"

#include <algorithm>

namespace vs {

namespace {

// How often a thread looks for what it waits for before it gives the processor away: some ten microseconds.
constexpr int kLooks = 1000;
// As many calls are done alone after one that had to wait for a thread which had lost its processor.
constexpr int kAlone = 32;

void breathe() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

} // namespace

void Crew::Job::takeParts() {
    for (std::size_t first = next.fetch_add(atOnce); first < count; first = next.fetch_add(atOnce)) {
        (*work)(first, std::min(first + atOnce, count));
    }
}

Crew::Crew(int threads) {
    try {
        for (int i = 1; i < threads; ++i) {
            threads_.emplace_back([this] { serve(); });
        }
    } catch (...) {
        sendHome();
        throw;
    }
}

Crew::~Crew() { sendHome(); }

void Crew::sendHome() {
    isOver_ = true;
    ++calls_;
    calls_.notify_all();
}

void Crew::run(std::size_t count, std::size_t atOnce,
               const std::function<void(std::size_t, std::size_t)>& work) {
    if (alone_ > 0) {
        --alone_;
        work(0, count);
        return;
    }
    Job job{count, atOnce, &work};
    job_ = &job;
    ++calls_;
    calls_.notify_all();
    job.takeParts();
    // Whoever comes from here on finds no job; those who found it are counted.
    job_ = nullptr;
    for (int looks = 0; atWork_ > 0; ++looks) {
        if (looks < kLooks) {
            breathe();
        } else {
            alone_ = kAlone;
            std::this_thread::yield();
        }
    }
}

// The number of the first call after the last one, once there is one.
std::uint32_t Crew::nextCall(std::uint32_t last) const {
    for (int i = 0; i < kLooks; ++i) {
        if (const std::uint32_t call = calls_; call != last) {
            return call;
        }
        breathe();
    }
    calls_.wait(last);
    return calls_;
}

void Crew::serve() {
    for (std::uint32_t call = nextCall(0); !isOver_; call = nextCall(call)) {
        ++atWork_;
        if (Job* const job = job_) {
            job->takeParts();
        }
        --atWork_;
    }
}

} // namespace vs

// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/decoder_at_hand.h"

#include "volume/reading/decoder_start.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <system_error>
#include <utility>
#include <vector>

namespace vs::volume {
namespace {

// Between a reading and the start of the next decoder: whoever has read goes on with that first.
constexpr std::chrono::milliseconds kRest{50};

// Where the decoder waits.
struct Shelf {
    std::mutex mutex; // held while one is started, so that who needs it then gets it a moment later
    std::condition_variable_any changed;
    bool isKeptFull = false;
    bool isWanted = false; // one is to be started
    std::optional<StartedDecoder> waiting = {};
    std::vector<StartedDecoder> used = {}; // to be ended
};

// Never destroyed: the program may be left while the thread below waits.
Shelf& shelf() {
    static Shelf& only = *new Shelf;
    return only;
}

// Starts decoders when they are wanted. A decoder ends with the thread that has started it (apps/decoder),
// so that this is a thread that lasts and none of those that come and go with what they read.
void startWanted(const std::stop_token& stop) {
    Shelf& here = shelf();
    std::unique_lock lock(here.mutex);
    while (here.changed.wait(lock, stop, [&] { return here.isWanted || !here.used.empty(); })) {
        if (std::vector<StartedDecoder> used = std::move(here.used); !used.empty()) {
            here.used.clear();
            lock.unlock();
            used.clear(); // which waits for their end
            lock.lock();
            here.changed.wait_for(lock, stop, kRest, [] { return false; });
        }
        if (!std::exchange(here.isWanted, false) || here.waiting || stop.stop_requested()) {
            continue;
        }
        try {
            here.waiting.emplace();
        } catch (const std::exception&) {
            // Whoever reads tries it again, and is told why it cannot be.
        }
    }
}

} // namespace

DecoderAtHand::DecoderAtHand() {
    try {
        starter_ = std::jthread(startWanted);
    } catch (const std::system_error&) {
        return; // there can be no more threads: decoders are started when they are needed
    }
    const std::lock_guard lock(shelf().mutex);
    shelf().isKeptFull = true;
    shelf().isWanted = true;
    shelf().changed.notify_all();
}

DecoderAtHand::~DecoderAtHand() {
    starter_ = {}; // waits for the thread's end
    const std::lock_guard lock(shelf().mutex);
    shelf().isKeptFull = false;
    shelf().isWanted = false;
    shelf().waiting.reset();
    shelf().used.clear();
}

pid_t DecoderAtHand::waiting() const {
    const std::lock_guard lock(shelf().mutex);
    return shelf().waiting ? shelf().waiting->process->id() : 0;
}

StartedDecoder takeDecoder() {
    std::optional<StartedDecoder> taken;
    {
        const std::lock_guard lock(shelf().mutex);
        shelf().isWanted = false; // processors are for this one now, until it was used
        taken = std::exchange(shelf().waiting, std::nullopt);
    }
    if (taken && taken->isUsable()) {
        return std::move(*taken);
    }
    return {};
}

void endDecoder(StartedDecoder&& used) {
    StartedDecoder own = std::move(used);
    const std::lock_guard lock(shelf().mutex);
    if (!shelf().isKeptFull) {
        return;
    }
    try {
        shelf().used.push_back(std::move(own));
    } catch (const std::bad_alloc&) {
        // It ends here, then.
    }
    shelf().isWanted = true;
    shelf().changed.notify_all();
}

} // namespace vs::volume

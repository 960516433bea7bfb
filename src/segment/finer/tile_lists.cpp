// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/tile_lists.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <utility>

namespace vs::segment {

namespace {

// What a thread has taken for itself.
struct Run {
    std::uint64_t epoch = 0;
    std::uint16_t* next = nullptr;
    std::size_t left = 0;
};
thread_local Run run;

std::uint64_t nextEpoch() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

} // namespace

TileLists::TileLists() : epoch_(nextEpoch()) {}

std::uint16_t* TileLists::take() noexcept {
    if (run.epoch != epoch_ || run.left == 0) {
        std::uint16_t* const some = takeSome();
        if (some == nullptr) {
            return nullptr;
        }
        run = {epoch_, some, kListsAtOnce};
    }
    --run.left;
    return std::exchange(run.next, run.next + kNumbers);
}

std::uint16_t* TileLists::takeSome() noexcept {
    const std::lock_guard lock(mutex_);
    const std::size_t block = used_ / kListsInBlock;
    if (block == blocks_.size()) {
        try {
            blocks_.push_back(std::make_unique_for_overwrite<std::uint16_t[]>(kListsInBlock * kNumbers));
        } catch (const std::bad_alloc&) {
            return nullptr;
        }
    }
    std::uint16_t* const some = blocks_[block].get() + used_ % kListsInBlock * kNumbers;
    used_ += kListsAtOnce;
    return some;
}

void TileLists::takeBackAll() {
    used_ = 0;
    epoch_ = nextEpoch();
    blocks_.resize(std::min(blocks_.size(), kBlocksKept));
}

} // namespace vs::segment

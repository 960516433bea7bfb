// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/brick_cache.h"

namespace vs::field {

BrickCache::Values BrickCache::get(const BrickKey& key, const std::function<std::vector<std::byte>()>& read) {
    std::unique_lock lock(mutex_);
    while (true) {
        const auto found = entries_.find(key);
        if (found == entries_.end()) {
            break;
        }
        if (found->second.values) {
            order_.splice(order_.begin(), order_, found->second.order);
            return found->second.values;
        }
        hasChanged_.wait(lock);
    }
    entries_[key].order = order_.end();
    lock.unlock();
    Values values;
    try {
        values = std::make_shared<const std::vector<std::byte>>(read());
    } catch (...) {
        lock.lock();
        entries_.erase(key);
        hasChanged_.notify_all();
        throw;
    }
    lock.lock();
    order_.push_front(key);
    entries_[key] = {values, order_.begin()};
    bytes_ += values->size();
    letGo();
    hasChanged_.notify_all();
    return values;
}

std::size_t BrickCache::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

void BrickCache::letGo() {
    while (bytes_ > mostBytes_ && order_.size() > 1) {
        const auto last = entries_.find(order_.back());
        bytes_ -= last->second.values->size();
        entries_.erase(last);
        order_.pop_back();
    }
}

} // namespace vs::field

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace vs::field {

// Values of bricks on the host, as many as a number of bytes has room for: those that were asked for last.
// Threads may call it at once.
class BrickCache {
public:
    using Values = std::shared_ptr<const std::vector<std::byte>>;

    explicit BrickCache(std::size_t mostBytes) : mostBytes_(mostBytes) {}

    // A brick's values, which `read` gives where they are not there; who asks for what is being read waits
    // for it. Throws what `read` throws; the next who asks tries again.
    Values get(const BrickKey& key, const std::function<std::vector<std::byte>()>& read);

    [[nodiscard]] std::size_t bytes() const;

private:
    struct Entry {
        Values values; // null while they are read
        std::list<BrickKey>::iterator order;
    };
    void letGo();

    std::size_t mostBytes_;
    mutable std::mutex mutex_;
    std::condition_variable hasChanged_;
    std::size_t bytes_ = 0;
    std::map<BrickKey, Entry> entries_;
    std::list<BrickKey> order_; // of those that are there, the one that was asked for last first
};

} // namespace vs::field

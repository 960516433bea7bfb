// SPDX-License-Identifier: Apache-2.0
#include "gl/device_bytes.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

namespace vs::gl {

namespace {

struct Counts {
    std::mutex mutex;
    std::map<std::pair<Counted, unsigned int>, std::size_t> sizes;
    DeviceBytes bytes;
};

// Never destroyed: textures may be deleted at the very end of a program.
Counts& counts() {
    static auto* const all = new Counts;
    return *all;
}

} // namespace

DeviceBytes deviceBytes() {
    const std::lock_guard lock(counts().mutex);
    return counts().bytes;
}

void countMade(Counted kind, unsigned int name, std::size_t bytes) {
    Counts& all = counts();
    const std::lock_guard lock(all.mutex);
    all.sizes[{kind, name}] = bytes;
    all.bytes.now += bytes;
    all.bytes.peak = std::max(all.bytes.peak, all.bytes.now);
}

void countDeleted(Counted kind, unsigned int name) {
    Counts& all = counts();
    const std::lock_guard lock(all.mutex);
    const auto found = all.sizes.find({kind, name});
    if (found != all.sizes.end()) {
        all.bytes.now -= found->second;
        all.sizes.erase(found);
    }
}

} // namespace vs::gl

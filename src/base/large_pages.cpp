// SPDX-License-Identifier: Apache-2.0
#include "base/large_pages.h"

#include <malloc.h>
#include <sys/mman.h>

#include <memory>

namespace vs {

void askForLargePages(std::span<std::byte> memory) {
    constexpr std::size_t page = 4096;
    constexpr std::size_t least = std::size_t(2) << 20;
    void* begin = memory.data();
    std::size_t space = memory.size();
    if (memory.size() >= least && std::align(page, page, begin, space) != nullptr) {
        madvise(begin, space / page * page,
                MADV_HUGEPAGE); // a system without them says no, which is all right
    }
}

void reserveInLargePages(std::vector<std::byte>& bytes, std::size_t count) {
    bytes.reserve(count);
    askForLargePages({bytes.data(), bytes.capacity()});
}

void keepFreedMemory() {
    mallopt(M_MMAP_THRESHOLD, 32 << 20); // less than that is taken from what was kept; the most there can be
    mallopt(M_TRIM_THRESHOLD, 128 << 20);
}

} // namespace vs

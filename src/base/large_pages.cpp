// SPDX-License-Identifier: Apache-2.0
#include "base/large_pages.h"

#include <sys/mman.h>

#include <memory>

namespace vs {

void reserveInLargePages(std::vector<std::byte>& bytes, std::size_t count) {
    constexpr std::size_t page = 4096;
    constexpr std::size_t least = std::size_t(2) << 20;
    bytes.reserve(count);
    void* begin = bytes.data();
    std::size_t space = bytes.capacity();
    if (count >= least && std::align(page, page, begin, space) != nullptr) {
        madvise(begin, space / page * page,
                MADV_HUGEPAGE); // a system without them says no, which is all right
    }
}

} // namespace vs

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <malloc.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <optional>

namespace vs::soak {

// What the process holds. A software renderer's textures and buffers are part of it.
struct Memory {
    std::size_t resident = 0; // bytes of memory that the system has given, freed ones that the heap keeps too
    std::size_t heap = 0;     // bytes that somebody has allocated and not freed

    static Memory now() {
        malloc_trim(0); // what is freed goes back to the system, or it would count as resident
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages >> pages; // the second number
        const auto found = mallinfo2();
        return {pages * std::size_t(sysconf(_SC_PAGESIZE)), found.uordblks + found.hblkhd};
    }
};

// How much of the heap a copy of a value takes: what the value itself holds there, but for what copies share.
template <typename T>
std::size_t heapBytesOf(const T& value) {
    const std::size_t before = Memory::now().heap;
    std::optional<T> copy;
    copy.emplace(value);
    return Memory::now().heap - before;
}

} // namespace vs::soak
